// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/pieces/limit_report.hpp"

#include <algorithm>

#include "ref/feed/pieces/piece_loads.hpp"
#include "ref/geometry/joint_geometry.hpp"
#include "ref/geometry/spline_geometry.hpp"
#include "ref/geometry/table_geometry.hpp"

namespace curvecore::ref {
namespace {

/// Restores the planned moves of a plan from its segments.
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
                 spline_stretches(program, machine, &plan.segments[i], next - i, plan.unit_mm)) {
                geometry.moves.push_back(stretch);
            }
        } else if (program.moves[index].kind == Move::Kind::kTable) {
            for (const PlannedMove& stretch :
                 table_stretches(program, machine, &plan.segments[i], next - i, plan.unit_mm)) {
                geometry.moves.push_back(stretch);
            }
        } else if (program.moves[index].kind == Move::Kind::kJoints) {
            for (const PlannedMove& stretch :
                 joint_stretches(program, machine, plan.segments[i], plan.unit_mm)) {
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

void LimitWatch::add(const Program& program, const Plan& part) {
    const Geometry geometry = moves_of(program, machine_, part);
    const PieceGrid grid(machine_, part.unit_mm, part.tick_s);
    PathPlaces places(program, geometry, part.unit_mm);
    if (before_ && !geometry.moves.empty()) pass(*before_, geometry.moves.front().shape, speed_);
    walk_pieces(part, geometry, grid, [&](const PieceStretch& stretch) {
        keep_loads(stretch, stretch.move_index, part, grid, machine_, places, report_.inside);
        if (!stretch.ends_move) return;
        const std::size_t next = stretch.move_index + 1;
        const double speed = motion(stretch, 1, part).v;
        if (next < geometry.moves.size()) {
            pass(stretch.move->shape, geometry.moves[next].shape, speed);
        } else {
            before_ = stretch.move->shape;
            speed_ = speed;
        }
    });
}

void LimitWatch::pass(const PathShape& before, const PathShape& behind, double speed) {
    // Words are rounded: a stop ends with a speed of some 1e-9 of the cruise.
    if (speed < 1e-6) return;
    ++report_.passed;
    keep_worst(report_.joints, joint_ratios(before, behind, machine_, speed));
}

LimitReport limit_report(const Program& program, const Machine& machine, const Plan& plan) {
    LimitWatch watch(machine);
    watch.add(program, plan);
    return watch.report();
}

}  // namespace curvecore::ref
