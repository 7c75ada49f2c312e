// SPDX-License-Identifier: Apache-2.0
// What a program costs as arcs, beside its splines and as chords of the same tolerance.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ref/curve/segment.hpp"
#include "ref/machine/machine.hpp"
#include "ref/program/spline_form.hpp"

namespace curvecore::sysc {

struct Options;

/// That the host sends: of segments and of profile pieces.
std::size_t words_of(const ref::Plan& plan);

struct FormCost {
    std::string form;
    std::size_t moves = 0;
    std::size_t segments = 0;
    std::size_t words = 0;
    double duration_s = 0;
};

struct AsArcs {
    ref::Program splines;  // the program before
    ref::Replaced replaced;
    std::vector<FormCost> costs;  // of arcs, splines, chords
};

/// What the program as it is written would cost; none where it cannot be planned.
std::optional<FormCost> exact_cost(const Options& options, const ref::Machine& machine,
                                   const ref::Program& programmed);

/// Fills `costs`: plans the other two with the same core. A core that cannot draw splines has no
/// row of them.
void compare_forms(AsArcs& as_arcs, const Options& options, const ref::Machine& machine,
                   const ref::Program& arcs, const ref::Plan& plan);

}  // namespace curvecore::sysc
