// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/hold_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/limits.hpp"
#include "ref/feed/piece_walk.hpp"
#include "ref/program/input_error.hpp"

namespace curvecore::ref {

namespace {

struct Slopes {
    double slope = 1e9;   // r', 1/s
    double change = 1e9;  // r'', 1/s^2

    /// A plan at its shares leaves the rest of every limit, whatever the direction. With time at
    /// the rate r the acceleration is r^2 a + r' v and the jerk r^3 j + 3 r r' a + r'' v, vectors
    /// but for v: what the limit sees of it, as of a.
    void keep_share(double v, double a, double acceleration, double jerk) {
        constexpr double kOfSlope = 0.8;  // of the jerk's rest: stops are quickest about here
        if (v == 0) return;
        const double room = (1 - kJerkShare) * jerk;
        slope = std::min(slope, (1 - kAccelerationShare) * acceleration / v);
        slope = std::min(slope, kOfSlope * room / (3 * a));
        change = std::min(change, (1 - kOfSlope) * room / v);
    }

    void set(const PlanOptions& options, Plan& plan) const;
};

void Slopes::set(const PlanOptions& options, Plan& plan) const {
    const double tick = options.tick_s();
    const double second = std::ldexp(change * tick * tick, 32);
    plan.hold_acceleration =
        static_cast<std::uint32_t>(std::clamp(std::floor(second), 1.0, 0x1p31));
    const double steps = std::ldexp(slope * tick, 32) / plan.hold_acceleration;
    const double most = std::floor(0x1p32 / plan.hold_acceleration);  // a slope of one per tick
    plan.hold_slope_steps = static_cast<std::uint32_t>(
        std::clamp(std::floor(steps), 1.0, std::min(most, 4294967295.0)));
    plan.stop_ticks = stop_ticks(plan.hold_acceleration, plan.hold_slope_steps);
}

}  // namespace

void set_hold_bounds(const Machine& machine, const PlanOptions& options, const Geometry& geometry,
                     Plan& plan) {
    Slopes of;
    const PieceGrid grid(machine, options.unit_mm, options.tick_s());
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        const PieceMotion from = motion(stretch, 0, plan);
        const PieceMotion to = motion(stretch, 1, plan);
        const double v = top_of(stretch, plan);
        const double a = std::max(std::abs(from.a), std::abs(to.a));
        if (options.effort == Effort::kOptimum) {
            const PathShape& shape = stretch.move->shape;
            const double across = v * v * shape.curvature;
            each_limit(
                shape, machine, [&](double rate, double bend, double acceleration, double jerk) {
                    const double most =
                        std::min(rate * a + bend * across, kAccelerationShare * acceleration);
                    of.keep_share(rate * v, most, acceleration, jerk);
                });
            return;
        }
        const PathLimits limits = along_path(stretch.move->shape, machine, v);
        // Pieces end on the grid, so a ramp may reach a little into the next move: there it has the
        // other move's limits, and half of the share left for holds is granted.
        const double pull =
            std::max(limits.acceleration - a, (1 - kAccelerationShare) / 2 * limits.acceleration);
        const double room =
            std::max(limits.jerk - std::abs(from.j), (1 - kJerkShare) / 2 * limits.jerk) / 3;
        if (v > 0) of.slope = std::min(of.slope, pull / v);
        if (a > 0) of.slope = std::min(of.slope, 2 * room / (3 * a));
        if (v > 0) of.change = std::min(of.change, room / v);
    });
    of.set(options, plan);
}

void set_hold_bounds(const Machine& machine, const PlanOptions& options, double fastest,
                     Plan& plan) {
    Slopes of;
    const auto keep = [&](double velocity, double acceleration, double jerk) {
        of.keep_share(std::min(fastest, velocity), kAccelerationShare * acceleration, acceleration,
                      jerk);
    };
    keep(machine.velocity, machine.acceleration, machine.jerk);
    for (const AxisLimits& axis : machine.axis) keep(axis.velocity, axis.acceleration, axis.jerk);
    of.set(options, plan);
}

std::uint32_t stop_ticks(std::uint32_t acceleration, std::uint32_t slope_steps) {
    const double a = std::ldexp(acceleration, -32);
    const double n = slope_steps;
    const double rising = std::min(n, std::sqrt(2 / a));
    const double falling = n * n * a < 1 ? 1 / (n * a) + n : 2 / std::sqrt(a);
    return static_cast<std::uint32_t>(std::min(std::ceil(rising + falling / 2) + 4, 0x1p31));
}

void set_segment_feeds(const Program& program, const PlanOptions& options, Plan& plan) {
    const double mm_per_s = options.unit_mm / 65536 / options.tick_s();
    const auto as_ticks = [&](std::uint64_t count, const Segment& segment) {
        if (count < (std::uint64_t{1} << 31)) return static_cast<std::uint32_t>(count);
        throw InputError(program.file, segment.line,
                         "a dwell of 2^31 ticks or more: take longer ticks or several dwells");
    };
    std::size_t piece = 0;
    std::uint64_t begin = 0;  // path and ticks at the start of the piece
    std::uint64_t ticks = 0;
    std::uint64_t drawn = 0;  // ticks of the segments so far
    double feed = piece_state(plan.pieces.front(), 0).v * mm_per_s;
    for (Segment& segment : plan.segments) {
        const std::uint64_t end = segment.s_start + segment.length;
        while (piece + 1 < plan.pieces.size() && begin + plan.pieces[piece].ds < end) {
            begin += plan.pieces[piece].ds;
            ticks += plan.pieces[piece++].ticks;
        }
        const ProfilePiece& p = plan.pieces[piece];
        const double time = ticks_at(p, static_cast<double>(end - begin));
        const std::uint64_t reached = ticks + static_cast<std::uint64_t>(time);
        segment.ticks = as_ticks(reached - drawn, segment);
        drawn = reached;
        segment.feed_start = feed;
        feed = std::max(0.0, piece_state(p, time).v * mm_per_s);
        segment.feed_end = feed;
    }
    // Whatever follows the last segment's end, rests and all, is its own.
    for (; piece < plan.pieces.size(); ++piece) ticks += plan.pieces[piece].ticks;
    Segment& last = plan.segments.back();
    last.ticks = as_ticks(last.ticks + ticks - drawn, last);
}

}  // namespace curvecore::ref
