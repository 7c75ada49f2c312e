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

/// Most moves of a program whose exact path is planned beside the drawn one: the longer ones would
/// wait for it twice as long as for their own plan.
constexpr std::size_t kMostBeside = 1000;

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

/// Adds the costs of the forms that the program is not drawn in, for a report: each is planned for
/// the same core. A form that cannot be planned has no row, nor has the exact path of a program of
/// more than kMostBeside moves.
void add_other_forms(Job& job);

}  // namespace curvecore::sysc
