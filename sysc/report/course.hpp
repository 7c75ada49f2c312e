// SPDX-License-Identifier: Apache-2.0
// Curvature and slope of the exact path, for the report's charts.
#pragma once

#include <array>
#include <vector>

#include "sysc/watch/pictures.hpp"

namespace curvecore::sysc {

/// Bins of equal path length.
struct Course {
    std::vector<Envelope> curvature;             // 1/mm; none where infinite
    std::array<std::vector<Envelope>, 3> slope;  // dx/ds, dy/ds, dz/ds
    std::vector<Envelope> deviation;  // bounds of the distance from the programmed path, mm
    std::vector<Envelope> tolerance;  // mm, of parts not drawn as programmed
};

Course course(const Job& job);

}  // namespace curvecore::sysc
