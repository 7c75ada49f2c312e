// SPDX-License-Identifier: Apache-2.0
// A window of a program, or all of it, and everything that its motion is made from.
#pragma once

#include <vector>

#include "ref/feed/ramps/phase.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// A motion that was planned before and stays: the first moves of a stretch.
struct GivenRun {
    std::size_t moves = 0;  // number of planned moves
    std::vector<Phase> phases;
};

inline std::size_t given_moves(const std::vector<GivenRun>& given) {
    std::size_t moves = 0;
    for (const GivenRun& run : given) moves += run.moves;
    return moves;
}

/// Context of all steps from a window's geometry to its pieces.
///
/// | field    | remark                                                                    |
/// |----------|---------------------------------------------------------------------------|
/// | geometry | of the window: path from 0, moves as in `program`; segments get ticks     |
/// | frame    | what all parts of the plan have, with bounds of holds                     |
/// | given    | motion of the first planned moves; none: it begins at rest                |
/// | whole    | it is the whole program: bounds of holds are found from its own motion    |
/// | more     | moves follow: the motion, which ends at rest, is to be cut before its end |
/// | least    | number of planned moves that are planned, whatever memory they take       |
/// | pace     | share of the speeds that the rules take                                   |
struct FeedTask {
    const Program& program;
    const Machine& machine;
    PlanOptions options;
    Geometry& geometry;
    const Plan& frame;
    const std::vector<GivenRun>& given;
    bool whole = false;
    bool more = false;
    std::size_t least = 0;
    double pace = 1;
};

}  // namespace curvecore::ref
