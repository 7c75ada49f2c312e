// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/limit_report.hpp"

#include <algorithm>

#include "ref/feed/path_places.hpp"
#include "ref/feed/piece_walk.hpp"
#include "ref/feed/spline_shape.hpp"
#include "ref/segment/spline_geometry.hpp"

namespace curvecore::ref {
namespace {

/// The planned moves of a plan, from its segments.
Geometry moves_of(const Program& program, const Machine& machine, const Plan& plan) {
    Geometry geometry;
    for (std::size_t i = 0; i < plan.segments.size();) {
        const std::size_t index = plan.segments[i].move;
        std::size_t next = i;
        PlannedMove planned;
        planned.move = index;
        for (; next < plan.segments.size() && plan.segments[next].move == index; ++next) {
            planned.length += plan.segments[next].length;
        }
        if (program.moves[index].kind == Move::Kind::kCubic) {
            for (const PlannedMove& stretch :
                 planned_spline(program, machine, &plan.segments[i], next - i, plan.unit_mm)) {
                geometry.moves.push_back(stretch);
            }
        } else {
            planned.shape = path_shape(program.moves[index]);
            geometry.moves.push_back(planned);
        }
        i = next;
    }
    return geometry;
}

void keep_worst(LimitRatios& worst, const LimitRatios& ratios) {
    worst.velocity = std::max(worst.velocity, ratios.velocity);
    worst.acceleration = std::max(worst.acceleration, ratios.acceleration);
    worst.jerk = std::max(worst.jerk, ratios.jerk);
}

/// From rest the loads vanish, but rounded words leave a speed where the curvature has no end.
bool near_standstill(const PlannedMove& move, double s, double quantum) {
    const double left = static_cast<double>(move.length) * quantum - s;
    return (move.stop_before && s < kTip) || (move.stop_after && left < kTip);
}

}  // namespace

LimitReport limit_report(const Program& program, const Machine& machine, const Plan& plan) {
    const Geometry geometry = moves_of(program, machine, plan);
    LimitReport report;
    const PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
    PathPlaces places(program, geometry, plan.unit_mm);
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        constexpr int kParts = 4;         // within a stretch all loads are smooth
        constexpr double kWithin = 1e-6;  // at its ends a curve may stand still
        for (int i = 0; i <= kParts && !stretch.overhang; ++i) {
            const double part = std::clamp(static_cast<double>(i) / kParts, kWithin, 1 - kWithin);
            const double t = stretch.from + (stretch.to - stretch.from) * part;
            const double s = stretch.s + piece_state(*stretch.piece, t).s -
                             piece_state(*stretch.piece, stretch.from).s;
            if (near_standstill(*stretch.move, s * grid.quantum, grid.quantum)) continue;
            const PathPlace at = places.at(stretch.move_index, s * grid.quantum);
            const PieceMotion m = motion(stretch, part, plan);
            for (const PlaceLimit& limit : place_limits(at, stretch.move->shape, machine)) {
                report.inside.acceleration =
                    std::max(report.inside.acceleration,
                             acceleration_of(limit, m.v, m.a) / limit.acceleration);
                report.inside.jerk =
                    std::max(report.inside.jerk, jerk_of(limit, m.v, m.a, m.j) / limit.jerk);
            }
        }
        report.inside.velocity =
            std::max(report.inside.velocity,
                     top_of(stretch, plan) / highest_speed(stretch.move->shape, machine));
        const std::size_t next = stretch.move_index + 1;
        if (!stretch.ends_move || next == geometry.moves.size()) return;
        const PieceMotion m = motion(stretch, 1, plan);
        // Words round: a stop ends with a speed of some 1e-9 of the cruise.
        if (m.v < 1e-6) return;
        ++report.passed;
        keep_worst(report.joints,
                   joint_ratios(stretch.move->shape, geometry.moves[next].shape, machine, m.v));
    });
    return report;
}

}  // namespace curvecore::ref
