// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/feed_profile.hpp"

#include <algorithm>

#include "ref/feed/feed_window.hpp"
#include "ref/feed/stops/hold_bounds.hpp"
#include "ref/feed/stops/planned_branches.hpp"
#include "ref/feed/stops/queue_cover.hpp"
#include "ref/feed/windows/window_rule.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr int kCoverRounds = 12;
constexpr double kCutFrom = 0.6;  // share of the planned time; what lies behind is planned again
// Share of the rules' speeds where an optimum joins them at a cut: it begins and ends within its
// limits.
constexpr double kPace = 0.95;
constexpr double kWithoutBranches = 0.99;  // ratio of times at which to give them up
constexpr double kGiven = 8;               // times the longest window, twice what FeedWindow sees
// Bounds of the motion that planning keeps, 1 to 3 kB for each knot and for every kSlow of time.
constexpr double kMostKnots = 8000;
constexpr double kSteady = 0.99;  // share of its feed at which a move has as few knots as a line
constexpr double kFew = 100;
constexpr double kSlow = 0.3;  // s

/// Returns the number of moves for which there is memory, by a motion that the rules give.
std::size_t enough_moves(const FeedTask& task, const WindowMotion& motion) {
    const std::vector<double>& times = motion.times();
    double knots = 0;
    for (std::size_t i = given_moves(task.given); i < task.geometry.moves.size(); ++i) {
        if (knots > kMostKnots && i >= task.least && motion.begins_move(i)) return i;
        const PlannedMove& planned = task.geometry.moves[i];
        const Move& move = task.program.moves[planned.move];
        const double time = times[i + 1] - times[i];
        const double step = knot_step(planned.shape, task.machine);
        const double feed = move.rapid || move.feed <= 0 ? kUnlimitedSpeed : move.feed;
        const bool steady = planned.shape.length >= kSteady * feed * time;
        const bool few = steady || move.kind == Move::Kind::kLine;
        knots += std::min(time / step, few ? kFew : kUnlimited) + time / kSlow;
    }
    return task.geometry.moves.size();
}

/// Returns the slowest joint; a stop counts as slowest, and of equal joints the last is taken.
std::size_t best_cut(const WindowMotion& motion, std::size_t open, const Machine& machine) {
    const double begin = motion.times()[open];
    const double end = motion.times().back();
    const double stopping =
        2 * (machine.velocity / (kAccelerationShare * machine.acceleration) + ramp_time(machine));
    const double from = begin + kCutFrom * (end - begin);
    const double to = std::max(end - stopping, (from + end) / 2);
    std::size_t best = 0;
    double slowest = 0;
    double nearest = kUnlimited;  // s, while no joint is in the range
    for (std::size_t i = open + 1; i + 1 < motion.times().size(); ++i) {
        if (!motion.begins_move(i)) continue;
        const double t = motion.times()[i];
        const double off = std::max({from - t, t - to, 0.0});
        if (off > nearest) continue;
        const double v = motion.speeds()[i];
        if (off == nearest && v > slowest) continue;
        nearest = off;
        slowest = v;
        best = i;
    }
    return best;
}

bool is_slowed(const Slowed& move) { return move.speed < Slowed().speed || move.ramp > 0; }

/// Makes a profile from the motion of a window: slower motion stops sooner, so that the queues last
/// longer, and a few rounds suffice. Returns none if the given motion cannot be continued, or if it
/// takes longer than `most` seconds.
/// @param slowed for each planned move, set to what it is slowed to
std::optional<WindowProfile> cover_motion(const FeedTask& task, std::size_t cut, double most,
                                          std::vector<Slowed>& slowed) {
    const std::size_t count = task.geometry.moves.size();
    const std::size_t given = given_moves(task.given);
    slowed.assign(count, {});
    Plan plan = task.frame;
    for (int round = 0;; ++round) {
        FeedWindow window(task, slowed, cut);
        if (!window.solve()) return {};
        WindowMotion found = window.motion();
        if (task.more && cut == 0) {
            cut = best_cut(found, given, task.machine);
            if (cut > 0 && window.cut_before(cut)) {
                found = window.motion();
            } else {
                cut = 0;
            }
        }
        if (round == 0) {  // endless queues for now: slowed motion has as many knots
            const std::size_t enough = enough_moves(task, found);
            if (enough < count) return WindowProfile{std::move(found), {}, cut, enough};
        }
        plan.pieces.clear();
        found.append(0, count, plan.pieces);
        found.append_last_dwell(plan.pieces);
        plan.duration_s = ticks_of(plan.pieces) * plan.tick_s;
        if (plan.duration_s > most) return {};
        if (task.whole) set_hold_bounds(task.machine, task.options, task.geometry, plan);
        set_segment_feeds(task.program, task.options, plan.pieces, task.geometry.segments);
        plan.branches.clear();
        const auto slow = [&] {
            return slow_to_cover(task.geometry, task.options, plan, given, round, slowed);
        };
        std::size_t more = slow();
        if (more == 0 && task.whole && task.options.has_branches()) {
            set_branches(task.program, task.machine, task.geometry, task.options, plan);
            more = slow();
        }
        if (more == 0) return WindowProfile{std::move(found), std::move(plan), cut, count};
        plan.slowed_moves = std::max(plan.slowed_moves, more);
        const auto first = std::find_if(slowed.begin(), slowed.end(), is_slowed) - slowed.begin();
        const PlannedMove& at = task.geometry.moves[static_cast<std::size_t>(first)];
        plan.slowed_line = task.program.moves[at.move].line;
        if (round == kCoverRounds) {
            throw InputError(task.program.file, 0,
                             "the moves are so short that what fits into the core's queues does "
                             "not outlast a stop at any speed tried");
        }
    }
}

}  // namespace

std::optional<WindowProfile> profile_window(FeedTask task) {
    const Effort effort = task.options.effort;
    const std::size_t count = task.geometry.moves.size();
    if (!task.whole && effort == Effort::kOptimum) task.pace = kPace;
    if (effort == Effort::kRules) task.least = count;
    task.options.effort = Effort::kRules;
    std::vector<Slowed> slowed;
    std::optional<WindowProfile> best = cover_motion(task, 0, kUnlimited, slowed);
    if (effort == Effort::kRules || !best || best->enough < count) return best;
    task.least = count;
    // More pieces need more queue, and so do stop branches: where that costs time, the optimum does
    // without them, and where it costs more than the optimum gains the rules stay.
    const std::size_t cut = best->cut;
    task.options.effort = effort;
    if (!carries_branches(task.machine, task.options, best->plan)) {
        task.options.holds = Holds::kBounds;
    }
    const auto improve = [&](double worth) {
        try {
            auto optimum = cover_motion(task, cut, worth * best->plan.duration_s, slowed);
            if (optimum) best = std::move(optimum);
        } catch (const InputError&) {  // the motion by rules stays
        }
    };
    improve(1);
    if (task.options.has_branches() && std::any_of(slowed.begin(), slowed.end(), is_slowed)) {
        task.options.holds = Holds::kBounds;
        improve(kWithoutBranches);
    }
    return best;
}

std::size_t given_from(const WindowMotion& motion, std::size_t cut, const Machine& machine) {
    const double from = motion.times()[cut] - kGiven * longest_window(machine);
    std::size_t first = cut;
    while (first > 0 && (motion.times()[first] > from || !motion.begins_move(first))) --first;
    return first;
}

}  // namespace curvecore::ref
