// SPDX-License-Identifier: Apache-2.0
#include "ref/plan/feed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "ref/plan/hold_bounds.hpp"
#include "ref/plan/limits.hpp"
#include "ref/plan/profile_words.hpp"

namespace curvecore::ref {
namespace {

constexpr double kMachineShare = 0.998;  // of velocities: rounding to the grid stays inside
constexpr double kJointShare = 0.99;     // the same at joints
// The shortest piece must resolve a ramp: so many of them up to full acceleration, and so little
// of the speed gained within one.
constexpr double kRampPieces = 4;
constexpr double kSpeedPieces = 100;

/// Speeds that the networks' latency allows, mm/s, one per planned move. A sample may cross several
/// steps as long as the clocks of its period suffice for them.
std::vector<double> latency_speeds(const Geometry& geometry, const PlanOptions& options) {
    const auto& moves = geometry.moves;
    double slowest = 0;  // step, clocks
    const auto latency = [&](const PlannedMove& move) {
        return move.spline ? options.spline_latency_clocks : options.network_latency_clocks;
    };
    for (const PlannedMove& move : moves) slowest = std::max(slowest, latency(move));
    const auto units = [&](std::size_t i) {
        return std::ldexp(static_cast<double>(moves[i].length), -16);
    };
    std::vector<double> speed(moves.size(), 1e9);
    // Of the steps that a sample crosses, the first and the last are cut.
    const double budget =
        (std::floor(options.sample_period_s * options.clock_hz / slowest) - 1) * slowest;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (budget < slowest) {
            speed[i] =
                units(i) / moves[i].steps * options.unit_mm * options.clock_hz / latency(moves[i]);
            continue;
        }
        double clocks = 0;
        double length = 0;
        std::size_t last = i;
        for (; last < moves.size() && clocks < budget; ++last) {
            const double all = moves[last].steps * latency(moves[last]);
            const double part = std::min(1.0, (budget - clocks) / all);
            clocks += part * all;
            length += part * units(last);
        }
        if (clocks < budget) length *= budget / clocks;  // the program's end
        const double v = length * options.unit_mm / options.sample_period_s;
        for (std::size_t m = i; m < last; ++m) speed[m] = std::min(speed[m], v);
    }
    return speed;
}

class FeedPlanner {
  public:
    FeedPlanner(const Program& program, const Machine& machine, const PlanOptions& options,
                const Geometry& geometry, Plan& plan)
        : program_(program),
          machine_(machine),
          geometry_(geometry),
          plan_(plan),
          grid_(machine, options.unit_mm, options.tick_s()),
          latency_speed_(latency_speeds(geometry, options)) {}

    void run() {
        std::size_t next = 0;  // move of the program
        for (std::size_t i = 0; i < geometry_.moves.size(); ++i) {
            const PlannedMove& planned = geometry_.moves[i];
            const Rest before = rest(next, planned.move);
            if (i > 0) join(geometry_.moves[i - 1], planned, before);
            if (zones_.empty()) append_rest(before.dwell, grid_, plan_.pieces);
            add_zone(i);
            next = planned.move;
        }
        finish_run();
        append_rest(rest(next, program_.moves.size()).dwell, grid_, plan_.pieces);
        if (!plan_.pieces.empty()) plan_.pieces.back().final = true;
        double ticks = 0;
        for (const ProfilePiece& piece : plan_.pieces) ticks += piece.ticks;
        plan_.duration_s = ticks * grid_.tick;
    }

  private:
    struct Rest {
        bool stop = false;
        double dwell = 0;
    };

    /// What the moves from `first` up to `last` (not included) ask for at their ends.
    Rest rest(std::size_t first, std::size_t last) const {
        Rest all;
        for (std::size_t i = first; i < last; ++i) {
            const Move& move = program_.moves[i];
            all.stop = all.stop || move.exact_stop || move.dwell > 0;
            all.dwell += std::max(0.0, move.dwell);
        }
        return all;
    }

    void join(const PlannedMove& before, const PlannedMove& after, const Rest& rest) {
        const bool stop = rest.stop || before.stop_after || after.stop_before;
        const double v = stop ? 0 : joint_velocity(before.shape, after.shape, machine_);
        if (v > 0) {
            zones_.push_back({0, kJointShare * v, 1e300, 1e300});
        } else {
            finish_run();
        }
    }

    void add_zone(std::size_t i) {
        const PlannedMove& planned = geometry_.moves[i];
        const Move& move = program_.moves[planned.move];
        double v = std::min({top_speed(planned.shape, machine_) * kMachineShare, latency_speed_[i],
                             fastest_word(grid_)});
        if (!move.rapid && move.feed > 0) v = std::min(v, move.feed / planned.shape.rate);
        const PathLimits limits = along_path(planned.shape, machine_, v);
        const double acceleration = kAccelerationShare * limits.acceleration;
        const double time = static_cast<double>(grid_.shortest) * grid_.tick;
        const double jerk = std::min({kJerkShare * limits.jerk, acceleration / (kRampPieces * time),
                                      v / (kSpeedPieces * time * time)});
        zones_.push_back({static_cast<double>(planned.length) * grid_.quantum, limits.velocity,
                          acceleration, jerk});
        run_length_ += planned.length;
    }

    void finish_run() {
        if (zones_.empty()) return;
        append_run(plan_speed(zones_), run_length_, grid_, plan_.pieces);
        zones_.clear();
        run_length_ = 0;
    }

    const Program& program_;
    const Machine& machine_;
    const Geometry& geometry_;
    Plan& plan_;
    PieceGrid grid_;
    std::vector<double> latency_speed_;
    std::vector<Zone> zones_;
    std::uint64_t run_length_ = 0;
};

}  // namespace

void plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
               const Geometry& geometry, Plan& plan) {
    FeedPlanner(program, machine, options, geometry, plan).run();
    set_hold_bounds(machine, options, geometry, plan);
    set_segment_feeds(options, plan);
}

}  // namespace curvecore::ref
