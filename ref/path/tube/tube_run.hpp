// SPDX-License-Identifier: Apache-2.0
// A stretch of the programmed path as a chain of cubics within a tube.
#pragma once

#include <vector>

#include "ref/path/tube/tube_knots.hpp"
#include "ref/path/tube/tube_spline.hpp"

namespace curvecore::ref {

/// A cubic that replaces the programmed path from `s0` to `s1`.
struct TubePiece {
    double s0;
    double s1;
    Bezier points;
    double deviation;  // mm, a bound, both ways
};

/// | field     | unit | remark                                    |
/// |-----------|------|-------------------------------------------|
/// | from, to  | mm   | of the programmed path                    |
/// | tolerance | mm   | > 0                                       |
/// | knots     | mm   | places of required knots, ascending       |
struct TubeTask {
    double from;
    double to;
    double tolerance;
    TubeEnd start;
    TubeEnd end;
    std::vector<double> knots;
};

/// Returns the chain, C2 inside; empty if no spline was found.
std::vector<TubePiece> tube_run(const ProgrammedPath& path, const TubeTask& task, const Pace& pace);

}  // namespace curvecore::ref
