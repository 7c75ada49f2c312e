// SPDX-License-Identifier: Apache-2.0
// Costs of a program in other forms: as written, as arcs, as splines and as chords of the same
// tolerance.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ref/moves/spline_form.hpp"

namespace curvecore::sysc {

struct Job;

struct FormCost {
    std::string form;
    std::size_t moves = 0;
    std::size_t segments = 0;
    std::size_t words = 0;  // words that the host sends
    double duration_s = 0;
};

struct AsArcs {
    ref::Replaced replaced;
    std::vector<FormCost> costs;  // costs of arcs, splines, chords
};

/// Plans the program in the forms that it is not drawn in, with the same core, for a report. A form
/// that cannot be planned has no row.
void plan_others(Job& job);

}  // namespace curvecore::sysc
