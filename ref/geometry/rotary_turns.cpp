// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/rotary_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/curve/axes.hpp"
#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

double travelled(const Move& move, std::size_t aux) {
    return std::abs(move.aux_end[aux] - move.aux_start[aux]);
}

}  // namespace

RotaryTurns::RotaryTurns(const Machine& machine, const PlanOptions& options)
    : machine_(machine), options_(options) {}

void RotaryTurns::leave_out(Segment& segment) const {
    const double turn = kTurnDegrees / options_.unit_mm;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        if (!machine_.axis[3 + i].rotary) continue;
        const double turned = std::trunc(segment.aux_start[i] / turn) * turn;
        segment.aux_start[i] -= turned;
        segment.aux_end[i] -= turned;
        segment.aux_turned[i] = turned;
    }
}

double RotaryTurns::longest() const {
    return std::ldexp(options_.unit_mm, options_.format.position_bits - 1) - kTurnDegrees;
}

double RotaryTurns::pieces(const Move& move) const {
    double pieces = 1;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        if (!machine_.axis[3 + i].rotary) continue;
        pieces = std::max(pieces, std::floor(travelled(move, i) / longest()) + 1);
    }
    return pieces;
}

std::string RotaryTurns::beyond_words(const Move& move, std::size_t axis) const {
    const double travel = travelled(move, axis - 3);
    const bool curve = move.kind != Move::Kind::kLine && move.kind != Move::Kind::kArc;
    const double one_segment = curve ? travel : 0;
    if (travel == 0 || longest() > one_segment) return "";
    return fmt::format(
        "{}: words of a turn and a segment's {:.6g} degrees need more than "
        "PositionBits {}, or a larger unit",
        kAxisLetters[axis], one_segment, options_.format.position_bits);
}

}  // namespace curvecore::ref
