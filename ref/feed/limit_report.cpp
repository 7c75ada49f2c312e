// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/limit_report.hpp"

#include <algorithm>

#include "ref/feed/piece_loads.hpp"
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

}  // namespace

LimitReport limit_report(const Program& program, const Machine& machine, const Plan& plan) {
    const Geometry geometry = moves_of(program, machine, plan);
    LimitReport report;
    const PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
    PathPlaces places(program, geometry, plan.unit_mm);
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        keep_loads(stretch, stretch.move_index, plan, grid, machine, places, report.inside);
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
