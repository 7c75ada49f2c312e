// SPDX-License-Identifier: Apache-2.0
#include "ref/join/joint.hpp"

#include <algorithm>

#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kStandingShare = 1e-9;     // share of the largest speed of a cubic
constexpr double kSharpestCurvature = 1e6;  // 1/mm: a radius of 1 nm
constexpr const char* kRapids = "no working move: a joint wants a move with a feed (G1, G2, ..)";

bool works(const Move& move) { return !move.rapid; }

void check_joint(const Program& program, const Move& move) {
    if ((move.end - move.start).isZero(0) && move.kind == Move::Kind::kLine) {
        throw InputError(program.file, move.line,
                         "the move at the joint moves auxiliary axes only: it has no direction");
    }
}

}  // namespace

Joint joint_of(const std::string& file, const Move& move, bool at_end) {
    const bool stands =
        move.kind == Move::Kind::kCubic &&
        !(move.cubic.speed(at_end ? 1 : 0) > kStandingShare * speed_range(move.cubic).max);
    if (stands) {
        throw InputError(file, move.line,
                         "no direction at the joint: the spline stands still there");
    }
    Joint joint{place_on(move, at_end ? move.length() : 0).by_length(), move.feed};
    joint.position = at_end ? move.end : move.start;
    if (!(joint.curvature.norm() < kSharpestCurvature)) {
        throw InputError(file, move.line, "the path is too sharp at the joint: radius below 1 nm");
    }
    return joint;
}

Program until_last_working_move(Program program) {
    auto& moves = program.moves;
    const auto last = std::find_if(moves.rbegin(), moves.rend(), works);
    if (last == moves.rend()) throw InputError(program.file, moves.back().line, kRapids);
    if (last->dwell > 0) {
        throw InputError(program.file, last->line,
                         "a dwell (G4) follows the last working move: an idle move goes on from "
                         "there without a stop");
    }
    check_joint(program, *last);
    moves.erase(last.base(), moves.end());
    moves.back().exact_stop = false;  // that of the program's end goes
    return program;
}

Program from_first_working_move(Program program) {
    auto& moves = program.moves;
    const auto first = std::find_if(moves.begin(), moves.end(), works);
    if (first == moves.end()) throw InputError(program.file, moves.back().line, kRapids);
    check_joint(program, *first);
    moves.erase(moves.begin(), first);
    return program;
}

}  // namespace curvecore::ref
