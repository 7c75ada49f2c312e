// SPDX-License-Identifier: Apache-2.0
// Pieces matched to moves: every stretch of a profile that lies on one move.
#pragma once

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/format/path_words.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

struct PieceStretch {
    const ProfilePiece* piece;
    const PlannedMove* move;
    std::size_t move_index;  // in Geometry::moves
    double from, to;         // ticks within the piece
    double s;                // quanta from the move's start, at `from`
    double gone;             // quanta of the piece up to there
    bool ends_move;          // the move ends here
    bool overhang;           // the piece's end is on the grid, the move's not: it reaches into a
                             // neighbouring move
};

struct PieceMotion {
    double v, a, j;  // mm/s, mm/s^2, mm/s^3
};

/// Time after which a piece has gone ds quanta, ticks: Newton's method in a bracket.
inline double ticks_at(const ProfilePiece& piece, double ds) {
    constexpr double kExact = 1e-14;  // share of the piece
    constexpr int kRounds = 60;
    double low = 0;
    double high = piece.ticks;
    if (ds <= 0) return low;
    if (ds >= static_cast<double>(piece.ds)) return high;
    double t = high * ds / static_cast<double>(piece.ds);
    for (int i = 0; i < kRounds; ++i) {
        const PieceState at = piece_state(piece, t);
        (at.s < ds ? low : high) = t;
        const double newton = t - (at.s - ds) / at.v;
        const double next = newton > low && newton < high ? newton : low + (high - low) / 2;
        const bool met = std::abs(next - t) <= kExact * piece.ticks;
        t = next;
        if (met) break;
    }
    return t;
}

/// Path from the start of a stretch's move to a tick of the piece, quanta.
inline double place_of(const PieceStretch& stretch, double tick) {
    return stretch.s + piece_state(*stretch.piece, tick).s - stretch.gone;
}

/// Motion at a fraction (0..1) of a stretch.
inline PieceMotion motion(const PieceStretch& stretch, double part, const Plan& plan) {
    const double t = stretch.from + (stretch.to - stretch.from) * part;
    const PieceState state = piece_state(*stretch.piece, t);
    const double v = plan.unit_mm * kQuantum / plan.tick_s;
    const double a = v / plan.tick_s;
    return {state.v * v, state.a * a, state.j * a / plan.tick_s};
}

/// Highest speed of a stretch, mm/s: at an end, or where the acceleration is zero.
inline double top_of(const PieceStretch& stretch, const Plan& plan) {
    const PieceMotion from = motion(stretch, 0, plan);
    const PieceMotion to = motion(stretch, 1, plan);
    double v = std::max(from.v, to.v);
    if (from.a > 0 && to.a < 0) v = std::max(v, motion(stretch, from.a / (from.a - to.a), plan).v);
    return v;
}

/// Visits the stretches in order of time, without rests.
template <class Visit>
void walk_pieces(const Plan& plan, const Geometry& geometry, const PieceGrid& grid, Visit visit) {
    std::size_t move = 0;
    std::uint64_t left = geometry.moves.empty() ? 0 : geometry.moves[0].length;
    for (const ProfilePiece& piece : plan.pieces) {
        std::uint64_t done = 0;
        double from = 0;
        while (done < piece.ds && move < geometry.moves.size()) {
            const std::uint64_t part = std::min(left, piece.ds - done);
            const auto s = static_cast<double>(geometry.moves[move].length - left);
            const auto gone = static_cast<double>(done);
            done += part;
            left -= part;
            const double to =
                done == piece.ds ? piece.ticks : ticks_at(piece, static_cast<double>(done));
            const bool starts = from == 0 && part < piece.ds;
            const bool ends = done == piece.ds && part < piece.ds;
            const bool joins = (starts && move + 1 < geometry.moves.size() &&
                                geometry.moves[move + 1].move != geometry.moves[move].move) ||
                               (ends && geometry.moves[move - 1].move != geometry.moves[move].move);
            const bool overhang = joins && to - from < static_cast<double>(grid.shortest);
            visit(PieceStretch{&piece, &geometry.moves[move], move, from, to, s, gone, left == 0,
                               overhang});
            from = to;
            if (left == 0 && ++move < geometry.moves.size()) left = geometry.moves[move].length;
        }
    }
}

}  // namespace curvecore::ref
