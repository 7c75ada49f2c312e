// SPDX-License-Identifier: Apache-2.0
#include "ref/plan/hold_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "ref/plan/limits.hpp"
#include "ref/plan/piece_walk.hpp"

namespace curvecore::ref {

void set_hold_bounds(const Machine& machine, const PlanOptions& options, const Geometry& geometry,
                     Plan& plan) {
    double slope = 1e9;   // r', 1/s
    double change = 1e9;  // r'', 1/s^2
    const PieceGrid grid(machine, options.unit_mm, options.tick_s());
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        const PieceMotion from = motion(stretch, 0, plan);
        const PieceMotion to = motion(stretch, 1, plan);
        const double v = top_of(stretch, plan);
        const double a = std::max(std::abs(from.a), std::abs(to.a));
        const PathLimits limits = along_path(stretch.move->shape, machine, v);
        // Pieces end on the grid, so a ramp may reach a little into the next move: there it has the
        // other move's limits, and half of the share left for holds is granted.
        const double pull =
            std::max(limits.acceleration - a, (1 - kAccelerationShare) / 2 * limits.acceleration);
        const double room =
            std::max(limits.jerk - std::abs(from.j), (1 - kJerkShare) / 2 * limits.jerk) / 3;
        if (v > 0) slope = std::min(slope, pull / v);
        if (a > 0) slope = std::min(slope, 2 * room / (3 * a));
        if (v > 0) change = std::min(change, room / v);
    });
    const double tick = options.tick_s();
    const double second = std::ldexp(change * tick * tick, 32);
    plan.hold_acceleration =
        static_cast<std::uint32_t>(std::clamp(std::floor(second), 1.0, 0x1p31));
    const double steps = std::ldexp(slope * tick, 32) / plan.hold_acceleration;
    const double most = std::floor(0x1p32 / plan.hold_acceleration);  // a slope of one per tick
    plan.hold_slope_steps = static_cast<std::uint32_t>(
        std::clamp(std::floor(steps), 1.0, std::min(most, 4294967295.0)));
}

void set_segment_feeds(const PlanOptions& options, Plan& plan) {
    const double mm_per_s = options.unit_mm / 65536 / options.tick_s();
    std::size_t piece = 0;
    std::uint64_t begin = 0;  // path at the start of the piece
    const auto feed_at = [&](std::uint64_t s) {
        while (piece < plan.pieces.size() && begin + plan.pieces[piece].ds < s) {
            begin += plan.pieces[piece++].ds;
        }
        if (piece == plan.pieces.size()) return 0.0;
        const ProfilePiece& p = plan.pieces[piece];
        return piece_state(p, ticks_at(p, static_cast<double>(s - begin))).v * mm_per_s;
    };
    double feed = 0;
    for (Segment& segment : plan.segments) {
        segment.feed_start = feed;
        feed = std::max(0.0, feed_at(segment.s_start + segment.length));
        segment.feed_end = feed;
    }
}

}  // namespace curvecore::ref
