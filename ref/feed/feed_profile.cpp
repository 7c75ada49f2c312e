// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/feed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/hold_bounds.hpp"
#include "ref/feed/limits.hpp"
#include "ref/feed/optimal_run.hpp"
#include "ref/feed/piece_loads.hpp"
#include "ref/feed/profile_words.hpp"
#include "ref/feed/queue_cover.hpp"
#include "ref/feed/step_speed.hpp"
#include "ref/feed/window_rule.hpp"
#include "ref/program/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kMachineShare = 0.998;  // of velocities: rounding to the grid stays inside
constexpr double kJointShare = 0.99;     // the same at joints
// The shortest piece must resolve a ramp: so many of them up to full acceleration, and so little
// of the speed gained within one.
constexpr double kRampPieces = 4;
constexpr double kSpeedPieces = 100;
constexpr double kCarried = 1.09;        // of a share: what rounding to ticks may add to an optimum
constexpr double kSpeedCarried = 1.001;  // the same of velocities
constexpr double kWorth = 0.01;          // of the time: what an optimum must be able to gain
constexpr int kRounds = 50;              // of planning; some five are seen

class FeedPlanner {
  public:
    FeedPlanner(const Program& program, const Machine& machine, const PlanOptions& options,
                const Geometry& geometry, const std::vector<double>& most, Plan& plan)
        : program_(program),
          machine_(machine),
          geometry_(geometry),
          plan_(plan),
          effort_(options.effort),
          places_(program, geometry, options.unit_mm),
          grid_(machine, options.unit_mm, options.tick_s()),
          step_speed_(step_speeds(plan.segments, geometry.moves, options)),
          most_(most) {}

    void run() {
        std::vector<Stretch> stretches = cut_at_stops();
        for (Stretch& stretch : stretches) {
            set_zones(stretch);
            plan(stretch);
        }
        keep_windows(stretches);
        for (const Stretch& stretch : stretches) {
            append_rest(stretch.dwell, grid_, plan_.pieces);
            append_run(stretch.phases, stretch.end - stretch.start, grid_, plan_.pieces);
        }
        append_rest(last_dwell_, grid_, plan_.pieces);
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

    /// From one stop to the next.
    struct Stretch {
        double dwell;             // before it, s
        std::size_t first, last;  // planned moves
        std::uint64_t start = 0;  // quanta
        std::uint64_t end = 0;
        std::vector<Zone> zones;   // moves and, between them, joints
        std::vector<double> caps;  // of zones, by the rule of windows
        std::vector<Phase> phases = {};
        bool changed = true;  // since its windows were looked at
        bool looked_at = true;

        void cap(std::size_t zone, double velocity) {
            caps[zone] = std::min(caps[zone], velocity);
            zones[zone].velocity = std::min(zones[zone].velocity, velocity);
        }
    };

    std::vector<Stretch> cut_at_stops() {
        std::vector<Stretch> stretches;
        std::size_t next = 0;  // move of the program
        std::uint64_t s = 0;
        for (std::size_t i = 0; i < geometry_.moves.size(); ++i) {
            const PlannedMove& planned = geometry_.moves[i];
            const Rest before = rest(next, planned.move);
            joint_speed_.push_back(0);
            if (i > 0) {
                const PlannedMove& last = geometry_.moves[i - 1];
                const bool stop = before.stop || last.stop_after || planned.stop_before;
                if (!stop) joint_speed_[i] = joint_velocity(last.shape, planned.shape, machine_);
            }
            if (joint_speed_[i] == 0) stretches.push_back({before.dwell, i, i, s, s, {}, {}});
            s += planned.length;
            stretches.back().last = i;
            stretches.back().end = s;
            next = planned.move;
        }
        last_dwell_ = rest(next, program_.moves.size()).dwell;
        return stretches;
    }

    void set_zones(Stretch& stretch) {
        for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
            if (i > stretch.first) {
                stretch.zones.push_back({0, kJointShare * joint_speed_[i], 1e300, 1e300});
            }
            stretch.zones.push_back(zone(i));
        }
        stretch.caps.assign(stretch.zones.size(), 1e9);
    }

    void plan(Stretch& stretch) {
        stretch.phases = plan_speed(stretch.zones);
        if (effort_ == Effort::kRules || one_line(stretch)) return;
        std::vector<RunMove> moves;
        double least = 0;  // s, without ramps
        for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
            const std::size_t zone = 2 * (i - stretch.first);
            const double highest = highest_speed(geometry_.moves[i].shape, machine_);
            RunMove move;
            move.planned = i;
            move.length = stretch.zones[zone].length;
            move.velocity = std::min(asked_speed(i, highest), stretch.caps[zone]);
            move.widest = knots_apart(program_.moves[geometry_.moves[i].move]);
            move.jerk = carried_jerk(move.velocity, kAccelerationShare * machine_.acceleration);
            if (i < stretch.last) {
                move.end_velocity =
                    std::min(stretch.caps[zone + 1], kJointShare * joint_speed_[i + 1]);
            }
            moves.push_back(move);
            least += move.length / move.velocity;
        }
        if (duration(stretch.phases) * (1 - kWorth) < least) return;
        stretch.phases = optimal_run(
            stretch.phases, moves, geometry_, machine_, places_,
            [&](const std::vector<Phase>& run) { return word_loads(stretch, moves, run); });
    }

    /// From rest to rest on a straight line the rules are the optimum.
    bool one_line(const Stretch& stretch) const {
        const Move& move = program_.moves[geometry_.moves[stretch.first].move];
        return stretch.first == stretch.last && move.kind == Move::Kind::kLine;
    }

    /// How many times as far apart as elsewhere knots may be while the speed is constant.
    static double knots_apart(const Move& move) {
        if (move.kind == Move::Kind::kCubic) return 2;
        return move.kind == Move::Kind::kArc ? 4 : 1e9;
    }

    /// Rounding to ticks may ask too much, as at joints within a few of them.
    std::vector<RunLoad> word_loads(const Stretch& stretch, const std::vector<RunMove>& moves,
                                    const std::vector<Phase>& phases) {
        Plan run;
        run.unit_mm = plan_.unit_mm;
        run.tick_s = plan_.tick_s;
        append_run(phases, stretch.end - stretch.start, grid_, run.pieces);
        Geometry own;
        const auto move = [this](std::size_t i) {
            return geometry_.moves.begin() + static_cast<std::ptrdiff_t>(i);
        };
        own.moves.assign(move(stretch.first), move(stretch.last + 1));
        std::vector<RunLoad> loads;
        double begin = 0;  // of the move, mm
        walk_pieces(run, own, grid_, [&](const PieceStretch& part) {
            LimitRatios worst;
            keep_loads(part, stretch.first + part.move_index, run, grid_, machine_, places_, worst);
            const double load =
                std::max(worst.acceleration / kAccelerationShare, worst.jerk / kJerkShare);
            const RunMove& on = moves[part.move_index];
            double speed = top_of(part, run) / on.velocity;
            if (part.ends_move && part.move_index + 1 < moves.size()) {
                speed = std::max(speed, motion(part, 1, run).v / on.end_velocity);
            }
            if (load > kCarried || speed > kSpeedCarried) {
                loads.push_back(
                    {begin + part.s * grid_.quantum, std::max(1.0, load), std::max(1.0, speed)});
            }
            if (part.ends_move) begin += static_cast<double>(part.move->length) * grid_.quantum;
        });
        return loads;
    }

    /// What feed, core and words allow of a speed that the machine does.
    double asked_speed(std::size_t i, double machine) const {
        const PlannedMove& planned = geometry_.moves[i];
        const Move& move = program_.moves[planned.move];
        const double v = std::min({machine * kMachineShare, step_speed_[i] * kMachineShare,
                                   most_[i], fastest_word(grid_)});
        return !move.rapid && move.feed > 0 ? std::min(v, move.feed / planned.shape.rate) : v;
    }

    double carried_jerk(double v, double acceleration) const {
        const double time = static_cast<double>(grid_.shortest) * grid_.tick;
        return std::min(acceleration / (kRampPieces * time), v / (kSpeedPieces * time * time));
    }

    Zone zone(std::size_t i) const {
        const PlannedMove& planned = geometry_.moves[i];
        const double v = asked_speed(i, top_speed(planned.shape, machine_));
        const PathLimits limits = along_path(planned.shape, machine_, v);
        const double acceleration = kAccelerationShare * limits.acceleration;
        const double jerk = std::min(kJerkShare * limits.jerk, carried_jerk(v, acceleration));
        return {static_cast<double>(planned.length) * grid_.quantum, limits.velocity, acceleration,
                jerk};
    }

    /// Plans again, slower, where the limits over windows are broken.
    void keep_windows(std::vector<Stretch>& stretches) {
        for (int round = 0; round < kRounds; ++round) {
            look_near_changes(stretches);
            VelocityCourse course(plan_.segments, plan_.unit_mm, 3 + program_.aux_axes, machine_);
            std::size_t segment = 0;
            for (const Stretch& stretch : stretches) {
                const std::size_t first = segment;
                while (segment < plan_.segments.size() &&
                       plan_.segments[segment].s_start < stretch.end) {
                    ++segment;
                }
                course.rest(stretch.dwell);
                if (stretch.looked_at) {
                    course.run(stretch.phases, first, segment - 1);
                } else {
                    course.rest(duration(stretch.phases));
                }
            }
            const std::vector<JointCap> caps = WindowRule(machine_, course).caps();
            if (caps.empty()) return;
            auto cap = caps.begin();
            for (Stretch& stretch : stretches) {
                const auto begin = cap;
                while (cap != caps.end() && cap->s < stretch.end) ++cap;
                stretch.changed = begin != cap;
                if (!stretch.changed) continue;
                lower(stretch, begin, cap);
                plan(stretch);
            }
        }
    }

    /// Stretches that a window with a part of a changed one may meet.
    void look_near_changes(std::vector<Stretch>& stretches) const {
        const double reach = 2 * longest_window(machine_);
        const auto look = [&](auto begin, auto end) {
            double time = 2 * reach;  // since the last change
            for (auto stretch = begin; stretch != end; ++stretch) {
                if (stretch->changed) time = 0;
                stretch->looked_at = stretch->looked_at || time <= reach;
                if (!stretch->changed) time += duration(stretch->phases);
            }
        };
        for (Stretch& stretch : stretches) stretch.looked_at = false;
        look(stretches.begin(), stretches.end());
        look(stretches.rbegin(), stretches.rend());
    }

    template <class Cap>
    void lower(Stretch& stretch, Cap cap, Cap end) const {
        std::uint64_t s = stretch.start;
        std::size_t after = 0;  // the last cap's joint
        for (std::size_t i = stretch.first; i < stretch.last && cap != end; ++i) {
            s += geometry_.moves[i].length;
            if (s != cap->s) continue;
            const std::size_t joint = 2 * (i - stretch.first) + 1;
            stretch.cap(joint, cap->velocity);
            for (std::size_t zone = after; cap->linked && zone != 0 && zone < joint; ++zone) {
                stretch.cap(zone, std::max(cap->velocity, stretch.zones[after].velocity));
            }
            after = joint;
            ++cap;
        }
    }

    const Program& program_;
    const Machine& machine_;
    const Geometry& geometry_;
    Plan& plan_;
    Effort effort_;
    PathPlaces places_;
    PieceGrid grid_;
    std::vector<double> step_speed_;
    const std::vector<double>& most_;  // mm/s, of each planned move
    std::vector<double> joint_speed_;  // before each planned move; 0: stop
    double last_dwell_ = 0;
};

/// Slower motion stops sooner, and the queues last longer: a few rounds do.
void plan_covered(const Program& program, const Machine& machine, const PlanOptions& options,
                  const Geometry& geometry, Plan& plan) {
    constexpr int kCoverRounds = 12;
    std::vector<double> most(geometry.moves.size(), 1e9);
    plan.slowed_moves = 0;
    for (int round = 0;; ++round) {
        plan.pieces.clear();
        FeedPlanner(program, machine, options, geometry, most, plan).run();
        set_hold_bounds(machine, options, geometry, plan);
        set_segment_feeds(program, options, plan);
        const std::size_t slowed = slow_to_cover(geometry, options, plan, most);
        if (slowed == 0) return;
        plan.slowed_moves = std::max(plan.slowed_moves, slowed);
        if (round == kCoverRounds) {
            throw InputError(program.file, 0,
                             "the moves are so short that what fits into the core's queues does "
                             "not outlast a stop at any speed tried");
        }
    }
}

}  // namespace

void plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
               const Geometry& geometry, Plan& plan) {
    PlanOptions rules = options;
    rules.effort = Effort::kRules;
    plan_covered(program, machine, rules, geometry, plan);
    if (options.effort == Effort::kRules) return;
    // More pieces want more queue: where that costs more than the optimum gains, the rules stay.
    Plan optimum = plan;
    try {
        plan_covered(program, machine, options, geometry, optimum);
    } catch (const InputError&) {
        return;
    }
    if (optimum.duration_s < plan.duration_s) plan = std::move(optimum);
}

}  // namespace curvecore::ref
