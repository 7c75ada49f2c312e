// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimal_run.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "ref/feed/limits.hpp"
#include "ref/feed/merged_phases.hpp"
#include "ref/feed/time_optimum.hpp"

namespace curvecore::ref {
namespace {

// Intervals that are solved at once, some 17 times to full acceleration, and how many of them are
// kept: the rest, more than it takes to full deceleration, is solved again with what follows.
constexpr std::size_t kWindow = 280;
constexpr std::size_t kCommitted = 240;
constexpr std::size_t kBeyond = 10;  // them, what needs easing is eased at once
// Shares of the time that the barrier may cost: first, to draw back from limits, and last.
constexpr double kFirstGap = 0.5;
constexpr double kBackGap = 0.0448;
constexpr double kGap = 0.004;
constexpr double kInside = 0.999;    // of a limit
constexpr double kKept = 1.01;       // of a limit's share
constexpr double kTolerated = 1.05;  // of it, after some rounds
constexpr double kMore = 0.02;       // by which limits are eased more, from round to round
constexpr RunLoads kAll{1e300, 1e300};
constexpr int kRounds = 3;
constexpr int kMostRounds = 8;
// Intervals that are eased on both sides of where words take too much, and those solved again.
constexpr std::size_t kNear = 2;
constexpr std::size_t kAround = 60;  // and as many more for each time before
constexpr int kMends = 10;
constexpr int kMostMends = 40;  // in a long run some places are always left
constexpr double kMendMore = 0.05;
// What crawls for minutes without a stop, since a short queue covers no more, is left to the rules.
constexpr double kLongest = 600;           // s
constexpr std::size_t kMostKnots = 24000;  // some 2 kB each
// Of a share and of a velocity, what a few words may take after so many mends.
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

    /// False: the ends, where they are in motion, leave no way to keep the limits.
    bool solve() {
        if (!optimum_.slow_down(1, end_)) return false;
        for (std::size_t first = 1;; first += kCommitted) {
            const bool whole = first + kWindow + kCommitted / 2 >= end_;
            const std::size_t last = whole ? end_ : first + kWindow;
            optimum_.improve(first, last, kFirstGap, kGap);
            settle(first, last, whole ? end_ : first + kCommitted + kBeyond, {}, kBackGap);
            if (whole) return true;
        }
    }

    /// Takes less where the words take too much, and less still where they did before, over a
    /// longer way.
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
            const double back = std::min(kFirstGap, std::ldexp(kBackGap, most));
            settle(first, last, last, std::move(eased), back);
        }
    }

    const std::vector<Phase>& phases() const { return found_; }
    /// How often each has been mended.
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

    /// Where the true path asks for more than its interval's limits did, they are eased.
    void settle(std::size_t first, std::size_t last, std::size_t kept, Eased eased, double back) {
        for (int round = 0;; ++round) {
            if (!eased.empty()) {
                optimum_.improve(first, last, back, back);
                ease(first, last, eased);
                optimum_.improve(first, last, back, kGap);
                back = std::min(kFirstGap, 3 * back);
            }
            eased.clear();
            double worst = 0;
            for (std::size_t k = first - 1; k <= kept; ++k) {
                found_[k] = phase(k);
                const double load = path_.loads(found_[k], k, k + 1, kAll).load;
                worst = std::max(worst, load);
                if (load <= kKept) continue;
                eased.push_back({k, (1 - kMore * round) * optimum_.load(k) / load, 1});
            }
            if (worst <= (round < kRounds ? kKept : kTolerated) || round == kMostRounds) return;
        }
    }

    void ease(std::size_t first, std::size_t last, const Eased& eased) {
        const auto all = [&](double load) {  // of what is taken now
            for (const Ease& e : eased) {
                const PathInterval& now = optimum_.interval(e.interval);
                optimum_.ease(
                    e.interval,
                    std::min(now.share, std::max(e.share, load * optimum_.load(e.interval))),
                    std::min(now.speed, std::max(e.speed, load * optimum_.speed_load(e.interval))));
            }
        };
        const Eased before = shares(eased);
        all(0);
        if (optimum_.slow_down(first, last)) return;
        for (const Ease& e : before) optimum_.ease(e.interval, e.share, e.speed);
        all(1 / kInside);  // by and by, then
    }

    Eased shares(const Eased& of) const {
        Eased now;
        for (const Ease& e : of) {
            const PathInterval& interval = optimum_.interval(e.interval);
            now.push_back({e.interval, interval.share, interval.speed});
        }
        return now;
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
    std::size_t end_;  // of free control points
    std::vector<Phase> found_;
    std::vector<int> mends_;
};

}  // namespace

std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine, PathPlaces& places,
                               const WordLoads& word_loads) {
    if (duration(phases) > kLongest) return phases;
    const std::vector<RunKnot> knots = run_knots(phases, moves);
    if (knots.size() > kMostKnots) return phases;
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
