// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/optimal_run.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

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
constexpr std::size_t kAround = 60;  // this many more for each time before
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
            const std::size_t last = whole ? end_ : first + window;
            TimeOptimum::State roomy = improve(first, last);
            const std::size_t led = whole ? end_ : optimum_.led_by_end(first, last, kGap);
            if (led < first + window / 2 && window < kLongestWindow && !whole) {
                window *= 2;
                continue;
            }
            const std::size_t next = std::max(led, first + window / 2);
            settle(first, last, std::min(last, next + kBeyond), std::move(roomy));
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
        for (auto load = loads.begin(); load != loads.end();) {
            const std::size_t at = std::clamp<std::size_t>(interval_at(load->s), 1, end_ - 1);
            const std::size_t around = kAround * (1 + static_cast<std::size_t>(before[at]));
            const std::size_t first = at > around ? at - around : 1;
            const std::size_t last = std::min(end_, at + around);
            Eased eased;
            int most = 0;
            for (; load != loads.end(); ++load) {
                const std::size_t k = interval_at(load->s);
                if (k + kNear >= last && last < end_) break;
                const std::size_t from = std::max(k, first + kNear) - kNear;
                const std::size_t to = std::min(k + kNear, last - 1);
                int times = 0;
                for (std::size_t i = from; i <= to; ++i) times = std::max(times, before[i]);
                const double less = 1 - kMendMore * std::min(times, kMends);
                for (std::size_t i = from; i <= to; ++i) {
                    eased.push_back({i, less_of(less * optimum_.load(i), load->load),
                                     less_of(optimum_.speed_load(i), load->speed)});
                    mends_[i] = times + 1;
                }
                most = std::max(most, times);
            }
            mend(first, last, std::move(eased), most);
        }
    }

    const std::vector<Phase>& phases() const { return found_; }
    /// Number of mends of each interval.
    const std::vector<int>& mends() const { return mends_; }

  private:
    struct Ease {
        std::size_t interval;
        double share, speed;
    };
    using Eased = std::vector<Ease>;

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
    /// the window again from where it had room.
    void settle(std::size_t first, std::size_t last, std::size_t kept, TimeOptimum::State roomy) {
        for (int round = 0;; ++round) {
            const Eased eased = missed(first, kept, round);
            if (eased.empty()) return;
            optimum_.restore(roomy);
            if (!ease(first, last, eased)) ease_by_and_by(eased);
            roomy = optimum_.state(first, last);
            optimum_.improve(first, last, kNextGap, kGap);
        }
    }

    /// Eases these in what is solved, then what is still missed.
    void mend(std::size_t first, std::size_t last, Eased eased, int times) {
        for (int round = 0; !eased.empty(); ++round) {
            draw_back(first, last, eased, back_gap(times + round));
            eased = missed(first, last, round);
        }
    }

    void draw_back(std::size_t first, std::size_t last, const Eased& eased, double back) {
        optimum_.improve(first, last, back, back);
        if (!ease(first, last, eased)) ease_by_and_by(eased);
        optimum_.improve(first, last, back, kGap);
    }

    static double back_gap(int times) { return std::min(kFirstGap, kBackGap * std::pow(3, times)); }

    /// Returns the easing, up to interval `last`, that keeps the limits; after some rounds, none.
    Eased missed(std::size_t first, std::size_t last, int round) {
        Eased eased;
        double worst = 0;
        for (std::size_t k = first - 1; k <= last; ++k) {
            found_[k] = phase(k);
            const double load = path_.loads(found_[k], k, k + 1, kAll).load;
            worst = std::max(worst, load);
            if (load <= kKept) continue;
            eased.push_back({k, (1 - kMore * round) * optimum_.load(k) / load, 1});
        }
        const bool kept = worst <= (round < kRounds ? kKept : kTolerated) || round >= kMostRounds;
        return kept ? Eased{} : eased;
    }

    /// Returns false, easing nothing, if no motion was found that keeps this.
    bool ease(std::size_t first, std::size_t last, const Eased& eased) {
        Eased before;
        for (const Ease& e : eased) {
            const PathInterval& now = optimum_.interval(e.interval);
            before.push_back({e.interval, now.share, now.speed});
        }
        for (const Ease& e : eased) take_no_more(e);
        if (optimum_.slow_down(first, last)) return true;
        for (const Ease& e : before) optimum_.ease(e.interval, e.share, e.speed);
        return false;
    }

    /// Eases gradually, to no less than what is taken now.
    void ease_by_and_by(const Eased& eased) {
        for (const Ease& e : eased) {
            take_no_more({e.interval, std::max(e.share, optimum_.load(e.interval) / kInside),
                          std::max(e.speed, optimum_.speed_load(e.interval) / kInside)});
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
