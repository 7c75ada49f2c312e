// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/spline_form.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "ref/curve/fit/arc_fit.hpp"

namespace curvecore::ref {
namespace {

Move piece_of(const Move& spline, const TangentArc& arc) {
    Move move = spline;
    move.cubic = Cubic();
    move.start = arc.start;
    move.end = arc.end;
    move.kind = arc.angle > 0 ? Move::Kind::kArc : Move::Kind::kLine;
    if (arc.angle > 0) {
        move.centre = arc.start + arc.radius * arc.inward;
        move.normal = arc.tangent.cross(arc.inward).normalized();
        move.angle = arc.angle;
    }
    return move;
}

TangentArc with_ends(const TangentArc& arc, const Vec3& start, const Vec3& end) {
    return arc.angle > 0 ? tangent_arc(start, arc.tangent, end) : straight(start, end);
}

std::vector<TangentArc> chords(const Cubic& cubic, double tolerance) {
    std::vector<TangentArc> lines;
    Vec3 from = cubic.position(0);
    for (const double u : fit_chords(cubic, tolerance)) {
        const Vec3 to = cubic.position(u);
        if (to != from) lines.push_back(straight(from, to));
        from = to;
    }
    return lines;
}

/// Shares the spline's auxiliary axes, stops and exact ends among its pieces.
void share(const Move& spline, std::vector<Move>& pieces) {
    double total = 0;
    for (const Move& piece : pieces) total += piece.length();
    double reached = 0;
    Aux aux = spline.aux_start;
    for (Move& piece : pieces) {
        const bool last = &piece == &pieces.back();
        piece.from = spline.from + (spline.to - spline.from) * (reached / total);
        reached += piece.length();
        if (!last) piece.to = spline.from + (spline.to - spline.from) * (reached / total);
        piece.aux_start = aux;
        for (std::size_t i = 0; !last && i < kAuxAxes; ++i) {
            aux[i] =
                spline.aux_start[i] + (spline.aux_end[i] - spline.aux_start[i]) * (reached / total);
        }
        piece.aux_end = last ? spline.aux_end : aux;
        piece.exact_stop = last && spline.exact_stop;
        piece.dwell = last ? spline.dwell : 0;
    }
}

}  // namespace

Replaced replace_splines(Program& program, SplineForm form, double tolerance) {
    Replaced replaced;
    if (form == SplineForm::kSpline) return replaced;
    std::vector<Move> moves;
    for (const Move& move : program.moves) {
        const double room = move.tolerance - move.deviation;
        const double within = move.deviation > 0 && room > 0 ? room : tolerance;
        if (move.kind != Move::Kind::kCubic || within == 0) {
            moves.push_back(move);
            continue;
        }
        ArcFit fit;
        if (form == SplineForm::kArcs) {
            fit = fit_arcs(move.cubic, within);
        } else {
            fit = {chords(move.cubic, within), within};
        }
        // The cubic's ends are the move's up to roundings.
        fit.arcs.front() = with_ends(fit.arcs.front(), move.start, fit.arcs.front().end);
        fit.arcs.back() = with_ends(fit.arcs.back(), fit.arcs.back().start, move.end);
        std::vector<Move> pieces;
        for (const TangentArc& arc : fit.arcs) {
            pieces.push_back(piece_of(move, arc));
            if (move.deviation > 0) pieces.back().deviation += fit.deviation;
        }
        share(move, pieces);
        ++replaced.splines;
        replaced.moves += pieces.size();
        replaced.deviation = std::max(replaced.deviation, fit.deviation);
        moves.insert(moves.end(), pieces.begin(), pieces.end());
    }
    program.moves = std::move(moves);
    return replaced;
}

}  // namespace curvecore::ref
