// SPDX-License-Identifier: Apache-2.0
// Stop branches of a part of a program, found while the program goes on.
#pragma once

#include <optional>
#include <vector>

#include "ref/geometry/geometry.hpp"
#include "ref/machine/machine.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// A part's own moves.
///
/// | field    | remark                                              |
/// |----------|-----------------------------------------------------|
/// | program  | moves from the first to the last that it draws of   |
/// | geometry | planned moves alone: they count in `program`        |
/// | at_rest  | true: the part ends at rest, where more may follow  |
struct PartMoves {
    Program program;
    Geometry geometry;
    bool at_rest = true;

    /// Copies planned moves, and of a program's those that they are of; `before` of the moves that
    /// they count are not in the program.
    PartMoves(const std::vector<PlannedMove>& planned, std::size_t first, std::size_t end,
              const Program& whole, std::size_t before);
};

/// A part's plan, and what its branches are found with, if it may have some that are not found yet.
struct PlannedPart {
    Plan plan;
    std::optional<PartMoves> moves;

    /// Sets the plan's branches; where the part does not end at rest, their stops end in it.
    void find_branches(const Machine& machine, const PlanOptions& options);
};

}  // namespace curvecore::ref
