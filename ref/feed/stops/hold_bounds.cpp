// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stops/hold_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ref/feed/pieces/piece_loads.hpp"
#include "ref/format/path_words.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {

namespace {

constexpr double kFineFrom = kFineRate / 65536.0;
constexpr double kFiner = 1 << kFineShift;
constexpr double kOfSlope = 0.8;    // share of the jerk's rest: most stops are quickest about here
constexpr double kRatios = 16;      // classes of a doubling of r'' / r'
constexpr double kMostRatio = 1e6;  // 1/s; what is steeper is as steep
constexpr int kSlopes = 32;         // slopes that are compared, and 0

/// Load of a motion on a limit.
struct Load {
    double v = 0;
    double a = 0;
    double j = 0;
};

/// Room that loads leave for the derivatives r' and r'' of time's rate in a hold. The bounds begin
/// finite, so steep that only a program that hardly moves keeps them.
class HoldRoom {
  public:
    void keep(const Load& load, double acceleration, double jerk) {
        keep(load, acceleration, jerk, kFineFrom, 1);
        keep(load, acceleration, jerk, 1, kFiner);
    }

    /// Sets bounds that share the least r' and the least r'' of the jerk alone at any places.
    void set(const PlanOptions& options, PlanFrame& plan) const;
    /// Sets the bounds with which a stop takes the fewest ticks.
    void set_quickest(const PlanOptions& options, PlanFrame& plan) const;

  private:
    /// Bounds by the jerk: r' / slope + r'' / change <= 1.
    struct Jerk {
        double slope = 1e9;   // 1/s
        double change = 1e9;  // 1/s^2
    };

    void keep(const Load& load, double acceleration, double jerk, double top, double finer);
    double least(double Jerk::*bound) const;

    double slope_ = 1e9;         // r' by the acceleration, 1/s
    std::map<int, Jerk> jerks_;  // least bounds by the logarithm of change / slope
};

/// Keeps the bounds within what the load leaves of the limits up to the rate `top`, for `finer` of
/// the bounds.
void HoldRoom::keep(const Load& load, double acceleration, double jerk, double top, double finer) {
    if (load.v == 0) return;
    const double rest = finer * (acceleration - top * top * load.a);
    const double room = finer * (jerk - top * top * top * load.j);
    slope_ = std::min(slope_, rest / load.v);
    const double bend = 3 * top * load.a;
    const double ratio = std::clamp(bend / load.v, 1 / kMostRatio, kMostRatio);
    Jerk& least = jerks_[static_cast<int>(std::lround(kRatios * std::log2(ratio)))];
    least.slope = std::min(least.slope, room / bend);
    least.change = std::min(least.change, room / load.v);
}

double HoldRoom::least(double Jerk::*bound) const {
    double least = Jerk().*bound;
    for (const auto& [ratio, jerk] : jerks_) least = std::min(least, jerk.*bound);
    return least;
}

/// Sets the bounds in words; returns false if the smallest words exceed them.
bool set_words(double slope, double change, const PlanOptions& options, PlanFrame& plan) {
    const double tick = options.tick_s();
    const double second = std::ldexp(change * tick * tick, 32);
    plan.hold_acceleration = static_cast<std::uint32_t>(
        std::clamp(std::floor(second / kFiner) * kFiner, kFiner, 0x1p31));
    const double steps = std::ldexp(slope * tick, 32) / plan.hold_acceleration;
    const double most = std::floor(0x1p32 / plan.hold_acceleration);  // a slope of one per tick
    plan.hold_slope_steps = static_cast<std::uint32_t>(
        std::clamp(std::floor(steps), 1.0, std::min(most, 4294967295.0)));
    plan.stop_ticks = stop_ticks(plan.hold_acceleration, plan.hold_slope_steps);
    return second >= kFiner && steps >= 1;
}

void HoldRoom::set(const PlanOptions& options, PlanFrame& plan) const {
    const double slope = std::min(slope_, kOfSlope * least(&Jerk::slope));
    set_words(slope, (1 - kOfSlope) * least(&Jerk::change), options, plan);
}

void HoldRoom::set_quickest(const PlanOptions& options, PlanFrame& plan) const {
    set(options, plan);
    const double most = std::min(slope_, least(&Jerk::slope));
    for (int step = 1; step < kSlopes; ++step) {
        const double slope = most * step / kSlopes;
        double change = kUnlimited;
        for (const auto& [ratio, jerk] : jerks_) {
            change = std::min(change, jerk.change * (1 - slope / jerk.slope));
        }
        PlanFrame other = plan;
        const bool kept = set_words(slope, change, options, other);
        if (kept && other.stop_ticks < plan.stop_ticks) plan = other;
    }
}

}  // namespace

void set_hold_bounds(const Machine& machine, const PlanOptions& options, const Geometry& geometry,
                     Plan& plan) {
    HoldRoom of;
    const PieceGrid grid(machine, options.unit_mm, options.tick_s());
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        const PieceMotion from = motion(stretch, 0, plan);
        const PieceMotion to = motion(stretch, 1, plan);
        const double v = top_of(stretch, plan);
        const double a = std::max(std::abs(from.a), std::abs(to.a));
        if (options.effort == Effort::kOptimum) {
            const PathShape& shape = stretch.move->shape;
            each_limit(shape, machine, [&](const LimitLoad& limit) {
                const double across = v * v * limit.curvature;
                const double most = std::min(limit.rate * a + limit.swing * across,
                                             kAccelerationShare * limit.acceleration);
                of.keep({limit.rate * v, most, kJerkShare * limit.jerk}, limit.acceleration,
                        limit.jerk);
            });
            return;
        }
        // Pieces end on the grid, so a ramp may reach a little into the next move: there it has the
        // other move's limits, and half of the share left for holds is granted.
        const PathLimits limits = along_path(stretch.move->shape, machine, v);
        const Load load{v, std::min(a, (1 + kAccelerationShare) / 2 * limits.acceleration),
                        std::min(std::abs(from.j), (1 + kJerkShare) / 2 * limits.jerk)};
        of.keep(load, limits.acceleration, limits.jerk);
    });
    of.set(options, plan);
}

void set_close_hold_bounds(const Program& program, const Machine& machine,
                           const PlanOptions& options, const Geometry& geometry, Plan& plan) {
    HoldRoom of;
    const PieceGrid grid(machine, options.unit_mm, options.tick_s());
    PathPlaces places(program, geometry, options.unit_mm);
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) {
        each_place(stretch, stretch.move_index, plan, grid, places,
                   [&](const PathPlace& at, const PieceMotion& m) {
                       for (const PlaceLimit& on : place_limits(at, stretch.move->shape, machine)) {
                           // Rounded words may take a little more than their share.
                           const Load load{
                               std::sqrt(on.d11) * std::max(0.0, m.v),
                               std::min(acceleration_of(on, m.v, m.a),
                                        kAccelerationShare * on.acceleration),
                               std::min(jerk_of(on, m.v, m.a, m.j), kJerkShare * on.jerk)};
                           of.keep(load, on.acceleration, on.jerk);
                       }
                   });
    });
    of.set_quickest(options, plan);
}

void set_hold_bounds(const Machine& machine, const PlanOptions& options, double fastest,
                     Plan& plan) {
    // The path takes no more than its axes do together, and X Y Z no more than the path; but joints
    // may take whatever their own limits are.
    const PathLimits path{machine.velocity, machine.acceleration, machine.jerk};
    PathLimits together{0, 0, 0};
    const bool joints = !is_trivial(machine.kinematics);
    HoldRoom of;
    const auto keep = [&](const PathLimits& own, const PathLimits& most) {
        of.keep({std::min({fastest, own.velocity, most.velocity}),
                 kAccelerationShare * std::min(own.acceleration, most.acceleration),
                 kJerkShare * std::min(own.jerk, most.jerk)},
                own.acceleration, own.jerk);
    };
    for (int i = 0; i < 3 + plan.aux_axes; ++i) {
        const AxisLimits& axis = machine.axis[static_cast<std::size_t>(i)];
        const PathLimits own{axis.velocity, axis.acceleration, axis.jerk};
        if (joints) {
            of.keep({own.velocity, kAccelerationShare * own.acceleration, kJerkShare * own.jerk},
                    own.acceleration, own.jerk);
        } else {
            keep(own, i < 3 ? path : own);
        }
        together = {std::hypot(together.velocity, own.velocity),
                    std::hypot(together.acceleration, own.acceleration),
                    std::hypot(together.jerk, own.jerk)};
    }
    keep(path, joints ? path : together);
    of.set(options, plan);
}

std::uint32_t stop_ticks(std::uint32_t acceleration, std::uint32_t slope_steps) {
    struct Bounds {
        double a, n;
        double time(double d) const {
            return n * n * a < d ? d / (n * a) + n : 2 * std::sqrt(d / a);
        }
    };
    const std::uint32_t eighth = acceleration >> kFineShift;
    const std::uint64_t fine_steps =
        (std::uint64_t{acceleration} * slope_steps >> kFineShift) / eighth;
    const Bounds whole{std::ldexp(acceleration, -32), static_cast<double>(slope_steps)};
    const Bounds fine{std::ldexp(eighth, -32), static_cast<double>(fine_steps)};
    const double border = 1 - kFineFrom;
    const double ticks = std::min(fine.n, fine.time(2 * border) / 2) +
                         fine.time(border) * (1 + kFineFrom) / 2 +
                         whole.time(kFineFrom) * kFineFrom / 2;
    return static_cast<std::uint32_t>(std::min(std::ceil(ticks) + 6 + kStopLead, 0x1p31));
}

void set_segment_feeds(const Program& program, const PlanOptions& options,
                       const std::vector<ProfilePiece>& pieces, std::vector<Segment>& segments) {
    const double mm_per_s = options.unit_mm * kQuantum / options.tick_s();
    const auto as_ticks = [&](std::uint64_t count, const Segment& segment) {
        if (count < (std::uint64_t{1} << 31)) return static_cast<std::uint32_t>(count);
        throw InputError(program.file, segment.line,
                         "a dwell of 2^31 ticks or more: take longer ticks or several dwells");
    };
    std::size_t piece = 0;
    std::uint64_t begin = 0;  // path and ticks at the start of the piece
    std::uint64_t ticks = 0;
    std::uint64_t drawn = 0;  // ticks of the segments so far
    double feed = piece_state(pieces.front(), 0).v * mm_per_s;
    for (Segment& segment : segments) {
        const std::uint64_t end = segment.s_start + segment.length;
        while (piece + 1 < pieces.size() && begin + pieces[piece].ds < end) {
            begin += pieces[piece].ds;
            ticks += pieces[piece++].ticks;
        }
        const ProfilePiece& p = pieces[piece];
        const double time = ticks_at(p, static_cast<double>(end - begin));
        const std::uint64_t reached = ticks + static_cast<std::uint64_t>(time);
        segment.ticks = as_ticks(reached - drawn, segment);
        drawn = reached;
        segment.feed_start = feed / segment.stretch;
        feed = std::max(0.0, piece_state(p, time).v * mm_per_s);
        segment.feed_end = feed / segment.stretch;
    }
    // The rest after the last segment's end belongs to that segment.
    for (; piece < pieces.size(); ++piece) ticks += pieces[piece].ticks;
    Segment& last = segments.back();
    last.ticks = as_ticks(last.ticks + ticks - drawn, last);
}

}  // namespace curvecore::ref
