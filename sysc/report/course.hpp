// SPDX-License-Identifier: Apache-2.0
// Curvature, slope and outputs along the path, for the report's charts.
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
    std::vector<int> outputs;         // bits that are on somewhere in it; empty: none ever is
    std::vector<double> power;  // greatest in it, 0..1; where it follows the speed, at the feed
};

Course course(const Job& job);

}  // namespace curvecore::sysc
