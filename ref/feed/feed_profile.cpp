// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/feed_profile.hpp"

#include <algorithm>

#include "ref/feed/core_slowed.hpp"
#include "ref/feed/feed_window.hpp"
#include "ref/feed/stops/hold_bounds.hpp"
#include "ref/feed/stops/planned_branches.hpp"
#include "ref/feed/stops/queue_cover.hpp"
#include "ref/feed/windows/window_rule.hpp"
#include "ref/limits/limits.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr int kCoverRounds = 12;
constexpr double kAnyTime = 1e300;  // s
constexpr double kCutFrom = 0.6;    // share of the planned time; what lies behind is planned again
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

/// The input of one planning run.
struct Subject {
    const Program& program;
    const Machine& machine;
    PlanOptions options;
    const Geometry& geometry;
    std::vector<GivenRun> given = {};
    bool window = false;  // bounds of holds are given
    bool more = false;    // more moves follow
    std::size_t least = 0;
    double pace = 1;
};

/// Returns the number of moves for which there is memory, by a motion that the rules give.
std::size_t enough_moves(const Subject& subject, const WindowMotion& motion) {
    const std::vector<double>& times = motion.times();
    double knots = 0;
    for (std::size_t i = given_moves(subject.given); i < subject.geometry.moves.size(); ++i) {
        if (knots > kMostKnots && i >= subject.least && motion.begins_move(i)) return i;
        const PlannedMove& planned = subject.geometry.moves[i];
        const Move& move = subject.program.moves[planned.move];
        const double time = times[i + 1] - times[i];
        const double step = knot_step(planned.shape, subject.machine);
        const double feed = move.rapid || move.feed <= 0 ? 1e9 : move.feed;
        const bool steady = planned.shape.length >= kSteady * feed * time;
        const bool few = steady || move.kind == Move::Kind::kLine;
        knots += std::min(time / step, few ? kFew : 1e300) + time / kSlow;
    }
    return subject.geometry.moves.size();
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
    double nearest = 1e300;  // s, while no joint is in the range
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

/// Plans with slower motion, which stops sooner so that the queues last longer: a few rounds
/// suffice. Returns none if it takes longer than `most` seconds.
std::optional<PlannedWindow> plan_covered(const Subject& subject, std::size_t cut, double most,
                                          Plan& plan) {
    const std::size_t count = subject.geometry.moves.size();
    const std::size_t given = given_moves(subject.given);
    std::vector<Slowed> slowed(count);
    const FeedTask task{subject.program, subject.machine, subject.options, subject.geometry,
                        plan.segments,   slowed,          subject.pace};
    plan.slowed_moves = 0;
    plan.slowed_line = 0;
    for (int round = 0;; ++round) {
        FeedWindow window(task, subject.given, cut);
        if (!window.plan()) return {};
        WindowMotion found = window.motion();
        if (subject.more && cut == 0) {
            cut = best_cut(found, given, subject.machine);
            if (cut > 0 && window.cut_before(cut)) {
                found = window.motion();
            } else {
                cut = 0;
            }
        }
        if (round == 0) {  // endless queues for now: slowed motion has as many knots
            const std::size_t enough = enough_moves(subject, found);
            if (enough < count) return PlannedWindow{std::move(found), cut, enough};
        }
        plan.pieces.clear();
        found.append(0, count, plan.pieces);
        found.append_last_dwell(plan.pieces);
        plan.duration_s = ticks_of(plan.pieces) * plan.tick_s;
        if (plan.duration_s > most) return {};
        if (!subject.window) {
            set_hold_bounds(subject.machine, subject.options, subject.geometry, plan);
        }
        set_segment_feeds(subject.program, subject.options, plan);
        plan.branches.clear();
        const auto slow = [&] {
            return slow_to_cover(subject.geometry, subject.options, plan, given, round, slowed);
        };
        std::size_t more = slow();
        if (more == 0 && !subject.window && subject.options.has_branches()) {
            set_branches(subject.program, subject.machine, subject.geometry, subject.options, plan);
            more = slow();
        }
        if (more == 0) return PlannedWindow{std::move(found), cut, count};
        plan.slowed_moves = std::max(plan.slowed_moves, more);
        const auto first = std::find_if(slowed.begin(), slowed.end(), [](const Slowed& move) {
            return move.speed < Slowed().speed || move.ramp > 0;
        });
        const auto at = static_cast<std::size_t>(first - slowed.begin());
        plan.slowed_line = subject.program.moves[subject.geometry.moves[at].move].line;
        if (round == kCoverRounds) {
            throw InputError(subject.program.file, 0,
                             "the moves are so short that what fits into the core's queues does "
                             "not outlast a stop at any speed tried");
        }
    }
}

/// Plans by rules, and by the optimum if it is asked for and faster.
std::optional<PlannedWindow> plan_best(Subject subject, Plan& plan) {
    const Effort effort = subject.options.effort;
    if (subject.window && effort == Effort::kOptimum) subject.pace = kPace;
    subject.options.effort = Effort::kRules;
    const std::size_t count = subject.geometry.moves.size();
    if (effort == Effort::kRules) subject.least = count;
    std::optional<PlannedWindow> rules = plan_covered(subject, 0, kAnyTime, plan);
    if (effort == Effort::kRules || !rules || rules->enough < count) return rules;
    subject.least = count;
    // More pieces need more queue, and so do stop branches: where that costs time, the optimum does
    // without them, and where it costs more than the optimum gains the rules stay.
    const std::size_t cut = rules->cut;
    std::optional<PlannedWindow> best = std::move(rules);
    subject.options.effort = effort;
    if (!carries_branches(subject.machine, subject.options, plan)) {
        subject.options.holds = Holds::kBounds;
    }
    // Returns false if the optimum was slowed for the queues, or there is none.
    const auto improve = [&](double worth) {
        Plan found = plan;
        std::optional<PlannedWindow> optimum;
        try {
            optimum = plan_covered(subject, cut, worth * plan.duration_s, found);
        } catch (const InputError&) {
            return false;
        }
        const bool fits = found.slowed_moves == 0;
        if (optimum) {
            plan = std::move(found);
            best = std::move(optimum);
        }
        return fits;
    };
    if (!improve(1) && subject.options.has_branches()) {
        subject.options.holds = Holds::kBounds;
        improve(kWithoutBranches);
    }
    return best;
}

}  // namespace

std::size_t plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
                      const Geometry& geometry, std::size_t least, Plan& plan) {
    const std::optional<PlannedWindow> planned =
        plan_best({program, machine, options, geometry, {}, false, false, least}, plan);
    const std::size_t count = geometry.moves.size();
    if (planned->enough < count) return planned->enough;
    plan.core_slowed = core_slowed({program, machine, options, geometry, plan.segments, {}},
                                   planned->motion, 0, count);
    plan.pieces.back().final = true;
    plan.segments.back().last = true;
    return planned->enough;
}

std::optional<PlannedWindow> plan_window(const Program& program, const Machine& machine,
                                         const PlanOptions& options, const Geometry& geometry,
                                         const std::vector<GivenRun>& given, bool more,
                                         std::size_t least, Plan& plan) {
    return plan_best({program, machine, options, geometry, given, true, more, least}, plan);
}

std::size_t given_from(const WindowMotion& motion, std::size_t cut, const Machine& machine) {
    const double from = motion.times()[cut] - kGiven * longest_window(machine);
    std::size_t first = cut;
    while (first > 0 && (motion.times()[first] > from || !motion.begins_move(first))) --first;
    return first;
}

}  // namespace curvecore::ref
