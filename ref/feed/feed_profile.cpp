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
// Share of an optimum: where a queue is short for more, all of it is slowed.
constexpr double kMost = 0.5;
constexpr double kSlowerExact = 0.004;  // share to which that is found
// Share of pieces: as few that were cut for branches are not worth a plan without.
constexpr double kCutPieces = 0.1;
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

/// Time from a cut to the end of its window that is enough for the motion before the cut.
double time_to_stop(const Machine& machine) {
    return 2 *
           (machine.velocity / (kAccelerationShare * machine.acceleration) + ramp_time(machine));
}

/// Returns the number of moves for which there is memory, and that are within the horizon, by a
/// motion that the rules give.
std::size_t enough_moves(const FeedTask& task, const WindowMotion& motion) {
    const std::vector<double>& times = motion.times();
    const std::size_t open = given_moves(task.given);
    const double end = times[open] + horizon(task.machine, task.options);
    double knots = 0;
    for (std::size_t i = open; i < task.geometry.moves.size(); ++i) {
        const bool full = knots > kMostKnots || times[i] > end;
        if (full && i >= task.least && motion.begins_move(i)) return i;
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
    const double stopping = time_to_stop(machine);
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

/// Returns the line of a planned move.
int line_of(const FeedTask& task, std::size_t planned) {
    return task.program.moves[task.geometry.moves[planned].move].line;
}

/// Returns true if a profile is longer for pieces that are cut for its stop branches.
bool costs_of_branches(const FeedTask& task, const Plan& plan) {
    if (!task.options.has_branches()) return false;
    const Reach longest = longest_piece({task.machine, plan.unit_mm, plan.tick_s});
    const auto cut = std::count_if(
        plan.pieces.begin(), plan.pieces.end(),
        [&](const ProfilePiece& piece) { return 2 * std::uint64_t{piece.ticks} > longest.ticks; });
    return static_cast<double>(cut) > kCutPieces * static_cast<double>(plan.pieces.size());
}

/// Fills in what follows from a motion: pieces, bounds of holds, feeds and branches. Returns what
/// the queues do not cover.
Uncovered lay(const FeedTask& task, const WindowMotion& motion, Plan& plan) {
    plan.pieces.clear();
    motion.append(0, task.geometry.moves.size(), plan.pieces);
    motion.append_last_dwell(plan.pieces);
    plan.duration_s = ticks_of(plan.pieces) * plan.tick_s;
    if (task.whole) set_hold_bounds(task.machine, task.options, task.geometry, plan);
    set_segment_feeds(task.program, task.options, plan.pieces, task.geometry.segments);
    plan.branches.clear();
    Uncovered without = uncovered(task.geometry, task.options, plan);
    if (without.any() && task.whole && task.options.effort == Effort::kOptimum) {
        set_close_hold_bounds(task.program, task.machine, task.options, task.geometry, plan);
        without = uncovered(task.geometry, task.options, plan);
    }
    if (!without.any() && task.whole && task.options.has_branches()) {
        set_branches(task.program, task.machine, task.geometry, task.options, plan);
    }
    return without;
}

/// Goes through all of a motion more slowly, no more than the queues need: stops are then shorter,
/// too. Returns none if that takes more than `most` seconds.
std::optional<WindowProfile> slow_all(const FeedTask& task, const FeedWindow& window,
                                      std::size_t cut, double most, const Plan& fastest) {
    std::optional<WindowProfile> best;
    double low = 1;
    for (double high = 2, factor = high; factor - low > kSlowerExact * low || !best;
         factor = best ? (low + high) / 2 : 2 * low) {
        WindowProfile slower{window.slower_motion(factor), fastest, cut,
                             task.geometry.moves.size()};
        if (!lay(task, slower.motion, slower.plan).any()) {
            slower.plan.slowed_moves = task.geometry.moves.size();
            slower.plan.slowed_line = line_of(task, 0);
            best.emplace(std::move(slower));
            high = factor;
        } else {
            low = factor;
            if (!best && low * fastest.duration_s > most) break;
        }
    }
    if (best && best->plan.duration_s > most) best.reset();
    const Plan& last = best ? best->plan : fastest;
    set_segment_feeds(task.program, task.options, last.pieces, task.geometry.segments);
    return best;
}

/// Makes a profile from the motion of a window: slower motion stops sooner, so that the queues last
/// longer, and a few rounds suffice. Returns none if the given motion cannot be continued, or if it
/// takes longer than `most` seconds.
/// @param branches set if those made the profile too long for its queue
std::optional<WindowProfile> cover_motion(const FeedTask& task, std::size_t cut, double most,
                                          bool& branches) {
    const std::size_t count = task.geometry.moves.size();
    const std::size_t given = given_moves(task.given);
    std::vector<Slowed> slowed(count);
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
        const Uncovered missing = lay(task, found, plan);
        if (plan.duration_s > most) return {};
        if (!missing.any()) return WindowProfile{std::move(found), std::move(plan), cut, count};
        branches = branches || (missing.pieces > 0 && costs_of_branches(task, plan));
        const bool all = std::max(missing.segments, missing.pieces) > kMost;
        if (all && task.whole && task.options.effort == Effort::kOptimum) {
            if (auto slower = slow_all(task, window, cut, most, plan)) return slower;
        }
        const std::size_t more =
            slow_to_cover(task.geometry, task.options, plan, given, round, slowed);
        if (more == 0) return WindowProfile{std::move(found), std::move(plan), cut, count};
        plan.slowed_moves = std::max(plan.slowed_moves, more);
        const auto first = std::find_if(slowed.begin(), slowed.end(), is_slowed) - slowed.begin();
        plan.slowed_line = line_of(task, static_cast<std::size_t>(first));
        if (round == kCoverRounds) {
            throw InputError(task.program.file, 0,
                             "the moves are so short that what fits into the core's queues does "
                             "not outlast a stop at any speed tried");
        }
    }
}

}  // namespace

double horizon(const Machine& machine, const PlanOptions& options) {
    return std::max(options.horizon_s, 2 * time_to_stop(machine));
}

std::optional<WindowProfile> profile_window(FeedTask task) {
    const Effort effort = task.options.effort;
    const std::size_t count = task.geometry.moves.size();
    if (!task.whole && effort == Effort::kOptimum) task.pace = kPace;
    if (effort == Effort::kRules) task.least = count;
    task.options.effort = Effort::kRules;
    bool branches = false;
    std::optional<WindowProfile> best = cover_motion(task, 0, kUnlimited, branches);
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
            auto optimum = cover_motion(task, cut, worth * best->plan.duration_s, branches);
            if (optimum) best = std::move(optimum);
        } catch (const InputError&) {  // the motion by rules stays
        }
    };
    improve(1);
    if (branches) {
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
