// SPDX-License-Identifier: Apache-2.0
#include "ref/path/tube/programmed_path.hpp"

#include <algorithm>
#include <cmath>

#include "ref/curve/fit/hermite.hpp"
#include "ref/moves/move_part.hpp"

namespace curvecore::ref {
namespace {

constexpr double kWidestPart = 0.12;  // rad

double local(const ProgrammedPath::Piece& piece, double s) { return (s - piece.s) / piece.length; }

}  // namespace

std::size_t ProgrammedPath::parts(const Move& move, double error) {
    if (move.kind == Move::Kind::kLine) return 1;
    const double radius = (move.start - move.centre).norm();
    const double widest = std::min(kWidestPart, std::pow(384 * error / radius, 0.25));
    return static_cast<std::size_t>(std::max(1.0, std::ceil(move.angle / widest)));
}

void ProgrammedPath::add(const Move& move, double error) {
    const std::size_t index = moves_++;
    if (move.kind == Move::Kind::kLine) {
        const Vec3 chord = move.end - move.start;
        pieces_.push_back(
            {length(), chord.norm(), {Vec3::Zero(), Vec3::Zero(), chord, move.start}, index});
        return;
    }
    const double radius = (move.start - move.centre).norm();
    const auto count = static_cast<int>(parts(move, error));
    error_ = std::max(error_, radius * std::pow(move.angle / count, 4) / 384);
    HermitePiece hermite;
    hermite.h = move.length() / count;
    MovePlace place = place_on(move, 0);
    for (int part = 1; part <= count; ++part) {
        hermite.start = place.position;
        hermite.start_d1 = place.tangent;
        place = place_on(move, part * hermite.h);
        hermite.end = place.position;
        hermite.end_d1 = place.tangent;
        pieces_.push_back({length(), hermite.h, cubic_of_slopes(hermite), index});
    }
}

std::size_t ProgrammedPath::piece_at(double s) const {
    const auto later = [](double place, const Piece& piece) { return place < piece.s; };
    const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), s, later);
    return static_cast<std::size_t>(next - pieces_.begin()) - 1;
}

Vec3 ProgrammedPath::position(double s) const {
    const Piece& piece = pieces_[piece_at(s)];
    return piece.cubic.position(local(piece, s));
}

}  // namespace curvecore::ref
