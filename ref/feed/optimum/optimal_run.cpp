// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/optimal_run.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <map>

#include "ref/feed/optimum/merged_phases.hpp"
#include "ref/feed/optimum/time_optimum.hpp"
#include "ref/limits/limits.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

// Intervals solved at once, some 34 times to full acceleration. Those that the window's end, which
// stays at a slower motion, does not slow down are kept; those that brake for it are solved again
// with what follows. If that is more than half of them, the window is too short.
constexpr std::size_t kWindow = 560;
constexpr std::size_t kLongestWindow = 16 * kWindow;
constexpr std::size_t kBeyond = 10;  // intervals beyond these, eased at once if they need it
// Shares of the time that the barrier may cost: first, then to draw back from limits, and last.
constexpr double kFirstGap = 0.5;
constexpr double kNextGap = 0.15;
constexpr double kBackGap = 0.0248;
constexpr double kGap = 0.004;
constexpr double kDip = 0.5;         // share of q at the start; 0.9 or more are usual
constexpr double kInside = 0.999;    // share of a limit
constexpr double kKept = 1.02;       // ratio to a limit's share
constexpr double kTolerated = 1.05;  // the same after some rounds
constexpr double kMore = 0.02;       // additional easing of limits from round to round
constexpr RunLoads kAll{kUnlimited, kUnlimited};
constexpr int kRounds = 3;
constexpr int kMostRounds = 8;
// Intervals eased on both sides of where words take too much, and those solved again.
constexpr std::size_t kNear = 2;
constexpr std::size_t kAround = 30;  // this many more for each time before
constexpr double kMost = 0.75;       // share of a window from which on all of it is solved again
constexpr int kMends = 10;
constexpr int kMostMends = 40;  // in a long run some places always remain
constexpr double kMendMore = 0.05;
// Tolerance of a share and of a velocity for a few words after that many mends.
constexpr double kCarried = 1.05;
static_assert(kCarried * kAccelerationShare < 1 && kCarried * kJerkShare < 1, "within limits");
constexpr double kSpeedCarried = 1.002;

class OptimalRun {
  public:
    OptimalRun(const std::vector<RunKnot>& knots, const RunPath& path)
        : knots_(knots),
          path_(path),
          optimum_(intervals(), motions()),
          end_(knots_.size() - 2),
          found_(knots_.size() - 1),
          mends_(knots_.size() - 1, 0) {}

    /// Returns false if the ends, where they are in motion, leave no way to keep the limits.
    bool solve() {
        if (!optimum_.slow_down(1, end_)) return false;
        std::size_t window = kWindow;
        for (std::size_t first = 1;;) {
            const bool whole = first + window + window / 2 >= end_;
            const std::size_t last =
                whole ? end_ : fastest(first + window - window / 10, first + window);
            TimeOptimum::State roomy = improve(first, last);
            const std::size_t led = whole ? end_ : optimum_.led_by_end(first, last, kGap);
            if (led < first + window / 2 && window < kLongestWindow && !whole) {
                window *= 2;
                continue;
            }
            const std::size_t next = std::max(led, first + window / 2);
            settle({first, last}, std::min(last, next + kBeyond), std::move(roomy));
            if (whole) return true;
            first = next;
        }
    }

    /// Lowers the shares where the words take too much, and further, over a longer way, where they
    /// did so before.
    void mend(const std::vector<RunLoad>& loads) {
        const std::vector<int> before = mends_;
        const auto less_of = [](double now, double taken) {  // where too much was taken
            return taken > 1 ? now / taken : 1;
        };
        Eased eased;
        for (const RunLoad& load : loads) {
            const std::size_t k = interval_at(load.s);
            const std::size_t from = std::max(k, 1 + kNear) - kNear;
            const std::size_t to = std::min(k + kNear, end_ - 1);
            int times = 0;
            for (std::size_t i = from; i <= to; ++i) times = std::max(times, before[i]);
            const double less = 1 - kMendMore * std::min(times, kMends);
            for (std::size_t i = from; i <= to; ++i) {
                add({i, less_of(less * optimum_.load(i), load.load),
                     less_of(optimum_.speed_load(i), load.speed), times},
                    eased);
                mends_[i] = times + 1;
            }
        }
        mend({1, end_}, end_, std::move(eased), kBackGap);
    }

    const std::vector<Phase>& phases() const { return found_; }
    /// Number of mends of each interval.
    const std::vector<int>& mends() const { return mends_; }

  private:
    /// | field        | remark                                   |
    /// |--------------|------------------------------------------|
    /// | share, speed | of the limits in an interval             |
    /// | times        | number of times that it was eased before |
    struct Ease {
        std::size_t interval;
        double share, speed;
        int times;
    };
    using Eased = std::map<std::size_t, Ease>;  // by interval

    /// Intervals that are solved at once, from their first free control point to their last.
    struct Part {
        std::size_t first, last;
        Eased eased = {};
        int times = 0;
    };

    static void add(const Ease& ease, Eased& eased) {
        const auto [at, is_new] = eased.try_emplace(ease.interval, ease);
        if (is_new) return;
        Ease& both = at->second;
        both.share = std::min(both.share, ease.share);
        both.speed = std::min(both.speed, ease.speed);
        both.times = std::max(both.times, ease.times);
    }

    /// Cuts a part into what is around the intervals that are eased, the farther the more often
    /// they were; they are together where that overlaps.
    static std::vector<Part> around(const Eased& eased, const Part& all) {
        std::vector<Part> parts;
        for (const auto& [k, ease] : eased) {
            const std::size_t reach = kAround * (1 + static_cast<std::size_t>(ease.times));
            if (parts.empty() || k >= parts.back().last) {
                parts.push_back({std::max(k, all.first + reach) - reach, k});
            }
            Part& part = parts.back();
            part.last = std::max(part.last, std::min(all.last, k + reach));
            part.times = std::max(part.times, ease.times);
            part.eased.insert({k, ease});
        }
        return parts;
    }

    std::size_t interval_at(double s) const {
        const auto after =
            std::upper_bound(knots_.begin(), knots_.end() - 1, s,
                             [](double at, const RunKnot& knot) { return at < knot.s; });
        return static_cast<std::size_t>(after - knots_.begin()) - 1;
    }

    std::vector<PathInterval> intervals() {
        std::vector<PathInterval> path;
        for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
            path.push_back(path_.interval(k));
        }
        return path;
    }
    std::vector<KnotMotion> motions() const {
        std::vector<KnotMotion> motions;
        for (const RunKnot& knot : knots_) motions.push_back({knot.v * knot.v, knot.a});
        return motions;
    }

    /// Returns where in this range the motion is fastest, as late as possible: a window that ends
    /// there brakes least for its end.
    std::size_t fastest(std::size_t from, std::size_t last) const {
        std::size_t best = last;
        for (std::size_t k = last; k-- > from;) {
            if (optimum_.spline().control(k) > optimum_.spline().control(best)) best = k;
        }
        return best;
    }

    /// Solves a window and returns a motion in it that has room within the limits. Far from its
    /// limits a motion may go down into a dip between two ramps, since the slower, the less jerk
    /// they take; it does not come up again at full jerk, but a motion that stays near them does
    /// not go there.
    TimeOptimum::State improve(std::size_t first, std::size_t last) {
        TimeOptimum::State begun = optimum_.state(first, last);
        optimum_.improve(first, last, kFirstGap, kFirstGap);
        TimeOptimum::State roomy = optimum_.state(first, last);
        optimum_.improve(first, last, kNextGap, kGap);
        if (!dips(begun)) return roomy;
        optimum_.restore(begun);
        optimum_.improve(first, last, kNextGap, kGap);
        return begun;
    }

    bool dips(const TimeOptimum::State& begun) const {
        for (std::size_t i = 0; i < begun.controls.size(); ++i) {
            const double now = optimum_.spline().control(begun.first + i);
            if (now < kDip * begun.controls[i]) return true;
        }
        return false;
    }

    /// Eases the limits of intervals in which the true path asks for more than they did, and solves
    /// again what is around them; where that is most of the window, all of it from where it had
    /// room.
    void settle(const Part& window, std::size_t kept, TimeOptimum::State roomy) {
        for (int round = 0;; ++round) {
            Eased eased = missed(window.first, kept, round);
            std::size_t again = 0;  // intervals
            std::size_t end = window.first;
            for (const Part& part : around(eased, window)) {
                again += part.last - std::max(end, part.first);
                end = part.last;
            }
            if (static_cast<double>(again) <
                kMost * static_cast<double>(window.last - window.first)) {
                mend(window, kept, std::move(eased), kNextGap);
                return;
            }
            optimum_.restore(roomy);
            if (!ease(window.first, window.last, eased)) ease_by_and_by(eased);
            roomy = optimum_.state(window.first, window.last);
            optimum_.improve(window.first, window.last, kNextGap, kGap);
        }
    }

    /// Eases these and solves again what is around them, then where up to interval `kept` limits
    /// are still missed.
    void mend(const Part& all, std::size_t kept, Eased eased, double back) {
        for (int round = 0; !eased.empty(); ++round) {
            Eased missing;
            for (const Part& part : around(eased, all)) {
                draw_back(part, std::min(kFirstGap, back * std::pow(3, part.times + round)));
                for (auto [k, ease] : missed(part.first, std::min(part.last, kept), round)) {
                    ease.times = part.times;
                    add(ease, missing);
                }
            }
            eased = std::move(missing);
        }
    }

    void draw_back(const Part& part, double back) {
        optimum_.improve(part.first, part.last, back, back);
        if (!ease(part.first, part.last, part.eased)) ease_by_and_by(part.eased);
        optimum_.improve(part.first, part.last, back, kGap);
    }

    /// Returns the easing, up to interval `last`, that keeps the limits; after some rounds, none.
    Eased missed(std::size_t first, std::size_t last, int round) {
        Eased eased;
        double worst = 0;
        for (std::size_t k = first - 1; k <= last; ++k) {
            found_[k] = phase(k);
            const double load = path_.loads(found_[k], k, k + 1, kAll).load;
            worst = std::max(worst, load);
            if (load <= kKept) continue;
            eased[k] = {k, (1 - kMore * round) * optimum_.load(k) / load, 1, 0};
        }
        const bool kept = worst <= (round < kRounds ? kKept : kTolerated) || round >= kMostRounds;
        return kept ? Eased{} : eased;
    }

    /// Returns false, easing nothing, if no motion was found that keeps this.
    bool ease(std::size_t first, std::size_t last, const Eased& eased) {
        Eased before = eased;
        for (auto& [k, e] : before) {
            e.share = optimum_.interval(k).share;
            e.speed = optimum_.interval(k).speed;
        }
        for (const auto& [k, e] : eased) take_no_more(e);
        if (optimum_.slow_down(first, last)) return true;
        for (const auto& [k, e] : before) optimum_.ease(k, e.share, e.speed);
        return false;
    }

    /// Eases gradually, to no less than what is taken now.
    void ease_by_and_by(const Eased& eased) {
        for (auto [k, e] : eased) {
            e.share = std::max(e.share, optimum_.load(k) / kInside);
            e.speed = std::max(e.speed, optimum_.speed_load(k) / kInside);
            take_no_more(e);
        }
    }

    void take_no_more(const Ease& e) {
        const PathInterval& now = optimum_.interval(e.interval);
        optimum_.ease(e.interval, std::min(now.share, e.share), std::min(now.speed, e.speed));
    }

    Phase phase(std::size_t k) const {
        const SpeedSpline& spline = optimum_.spline();
        const double length = spline.length(k);
        double duration = spline.time(k);
        if (!spline.rests(k)) {
            const PathMotion start = spline.motion(k);
            const auto slowness = [&](double x) { return 1 / std::sqrt(farther(start, x)[0]); };
            duration = boost::math::quadrature::gauss<double, 10>::integrate(slowness, 0., length);
        }
        return phase_between(knots_[k].s, length, std::sqrt(spline.knot(k).q),
                             std::sqrt(spline.knot(k + 1).q), duration);
    }

    const std::vector<RunKnot>& knots_;
    const RunPath& path_;
    TimeOptimum optimum_;
    std::size_t end_;  // end of free control points
    std::vector<Phase> found_;
    std::vector<int> mends_;
};

}  // namespace

std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine, PathPlaces& places,
                               const WordLoads& word_loads) {
    const std::vector<RunKnot> knots = run_knots(phases, moves);
    const RunPath path(moves, geometry, machine, places, knots);
    OptimalRun run(knots, path);
    if (!run.solve()) return phases;
    for (int round = 0; round <= kMostMends; ++round) {
        if (!(duration(run.phases()) < duration(phases))) break;
        std::vector<Phase> found = merged_phases(run.phases(), run.mends(), path, machine);
        const std::vector<RunLoad> loads = word_loads(found);
        double worst = 0;
        for (const RunLoad& load : loads) {
            worst = std::max({worst, load.load, kCarried * load.speed / kSpeedCarried});
        }
        if (loads.empty() || (round >= kMends && worst <= kCarried)) return found;
        run.mend(loads);
    }
    return phases;
}

}  // namespace curvecore::ref
