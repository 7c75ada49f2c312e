// SPDX-License-Identifier: Apache-2.0
#include "ref/path/smooth_path.hpp"

#include <algorithm>

#include "ref/path/smooth_stream.hpp"

namespace curvecore::ref {

Smoothed smooth_path(Program& program, const Machine& machine, double share) {
    SmoothStream stream(source_of(program), machine, share);
    std::vector<Move> moves;
    for (Move move; stream.next(move);) moves.push_back(move);
    program.moves = std::move(moves);
    return stream.report();
}

void look_at(const Move& move, Smoothed& smoothed) {
    smoothed.tolerance = std::max(smoothed.tolerance, move.tolerance);
    smoothed.deviation = std::max(smoothed.deviation, move.deviation);
    const double share =
        move.deviation > 0 ? move.deviation / std::max(move.tolerance, kExactDeviation) : 0;
    if (share > smoothed.share) {
        smoothed.share = share;
        smoothed.line = move.line;
    }
}

}  // namespace curvecore::ref
