// SPDX-License-Identifier: Apache-2.0
// Smooth paths of cubics, which may be drawn as arcs and chords, too (ref/moves/spline_form.hpp).
#pragma once

#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::tb {

inline void line_to(ref::Program& program, const ref::Vec3& end) {
    ref::Move move;
    if (!program.moves.empty()) move.start = program.moves.back().end;
    move.end = end;
    program.moves.push_back(move);
}

/// Adds a cubic with these derivatives at its ends.
inline void spline_to(ref::Program& program, const ref::Vec3& end, const ref::Vec3& out,
                      const ref::Vec3& in) {
    line_to(program, end);
    ref::Move& move = program.moves.back();
    move.kind = ref::Move::Kind::kCubic;
    ref::HermitePiece piece;
    piece.start = move.start;
    piece.end = end;
    piece.start_d1 = out;
    piece.end_d1 = in;
    move.cubic = ref::cubic_of_slopes(piece);
}

/// A turn back between two lines of 40 mm.
inline ref::Program spline_turn() {
    ref::Program program;
    line_to(program, {40, 0, 0});
    spline_to(program, {40, 5, 0}, {6.914, 0, 0}, {-6.914, 0, 0});
    line_to(program, {0, 5, 0});
    return program;
}

/// The wave y = 3 sin x over 60 mm, with its slopes every quarter of a wave.
inline ref::Program spline_wave() {
    ref::Program program;
    const double step = M_PI / 4;
    for (double x = step; x < 60; x += step) {
        spline_to(program, {x, 3 * std::sin(x), 0}, step * ref::Vec3(1, 3 * std::cos(x - step), 0),
                  step * ref::Vec3(1, 3 * std::cos(x), 0));
    }
    return program;
}

/// A long curve in space that turns little.
inline ref::Program gentle_spline() {
    ref::Program program;
    spline_to(program, {100, 30, 20}, {120, 0, 0}, {90, 60, 30});
    spline_to(program, {200, 20, 0}, {90, 60, 30}, {120, -40, -20});
    return program;
}

}  // namespace curvecore::tb
