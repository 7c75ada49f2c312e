// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/pieces/piece_loads.hpp"

#include <algorithm>

#include "ref/limits/spline_shape.hpp"

namespace curvecore::ref {
namespace {

constexpr int kParts = 4;  // parts of a stretch, where all loads are smooth

}  // namespace

bool near_standstill(const PlannedMove& move, double s, double quantum) {
    const double left = static_cast<double>(move.length) * quantum - s;
    return (move.stop_before && s < kTipLength) || (move.stop_after && left < kTipLength);
}

void each_place(const PieceStretch& stretch, std::size_t planned, const Plan& plan,
                const PieceGrid& grid, PathPlaces& places,
                const std::function<void(const PathPlace&, const PieceMotion&)>& visit) {
    for (int i = 0; i <= kParts; ++i) {
        const double part =
            std::clamp(static_cast<double>(i) / kParts, kWithinStretch, 1 - kWithinStretch);
        const double t = stretch.from + (stretch.to - stretch.from) * part;
        const double s = place_of(stretch, t) * grid.quantum;
        if (near_standstill(*stretch.move, s, grid.quantum)) continue;
        visit(places.at(planned, s), motion(stretch, part, plan));
    }
}

void keep_loads(const PieceStretch& stretch, std::size_t planned, const Plan& plan,
                const PieceGrid& grid, const Machine& machine, PathPlaces& places,
                LimitRatios& worst) {
    const PathShape& shape = stretch.move->shape;
    each_place(
        stretch, planned, plan, grid, places, [&](const PathPlace& at, const PieceMotion& m) {
            worst.velocity = std::max(worst.velocity, m.v / highest_speed(at.d1, shape, machine));
            if (stretch.overhang) return;
            for (const PlaceLimit& limit : place_limits(at, shape, machine)) {
                worst.acceleration = std::max(
                    worst.acceleration, acceleration_of(limit, m.v, m.a) / limit.acceleration);
                worst.jerk = std::max(worst.jerk, jerk_of(limit, m.v, m.a, m.j) / limit.jerk);
            }
        });
    worst.velocity = std::max(worst.velocity, top_of(stretch, plan) / path_speed(shape, machine));
}

}  // namespace curvecore::ref
