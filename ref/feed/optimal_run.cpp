// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimal_run.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "ref/feed/limits.hpp"
#include "ref/feed/time_optimum.hpp"

namespace curvecore::ref {
namespace {

constexpr double kKnots = 25;  // in the time to full acceleration
constexpr double kGap = 0.004;
constexpr int kPlaces = 6;            // of an interval, where it is checked
constexpr double kKept = 1.002;       // of a limit's share
constexpr double kSplit = 1.1;        // of it: the path changes within the interval
constexpr double kShortest = 0.2e-3;  // s
constexpr int kRounds = 12;
constexpr double kJump = 0.1;     // of jerk * JointTime: between merged phases
constexpr double kInside = 1e-6;  // of an interval: of two sides of a joint, its own

/// Time to full acceleration, of the quickest limit.
double ramp_time(const Machine& machine) {
    double time = machine.acceleration / machine.jerk;
    for (const AxisLimits& axis : machine.axis) {
        time = std::min(time, axis.acceleration / axis.jerk);
    }
    return time;
}

/// s(t) of an interval as constant jerk: path and speed of both ends.
Phase phase_of(long double s, double length, double v0, double v1, double duration) {
    Phase phase;
    phase.duration = duration;
    phase.s = s;
    phase.v = v0;
    phase.a = (6 * length / duration - 4 * v0 - 2 * v1) / duration;
    phase.j = (6 * (v0 + v1) - 12 * length / duration) / (duration * duration);
    return phase;
}

class OptimalRun {
  public:
    OptimalRun(const std::vector<RunMove>& moves, const Geometry& geometry, const Machine& machine,
               PathPlaces& places)
        : moves_(moves), geometry_(geometry), machine_(machine), places_(places) {
        begin_.push_back(0);
        for (const RunMove& move : moves) begin_.push_back(begin_.back() + move.length);
    }

    std::vector<Phase> run(const std::vector<Phase>& phases) {
        knots_ = run_knots(phases, moves_, ramp_time(machine_) / kKnots);
        for (int round = 0; round < kRounds; ++round) {
            const std::vector<Phase> found = solve();
            // Rounds only take longer; where the solver has lost its way, they do not end.
            if (!(duration(found) < duration(phases))) break;
            if (keeps(found)) return merged(found);
        }
        return phases;
    }

  private:
    std::size_t intervals() const { return knots_.size() - 1; }

    std::vector<Phase> solve() {
        std::vector<PathInterval> path;
        std::vector<KnotMotion> start;
        for (std::size_t k = 0; k < intervals(); ++k) path.push_back(interval(k));
        for (const RunKnot& knot : knots_) start.push_back({knot.v * knot.v, knot.a});
        const std::vector<KnotMotion> found = time_optimum(path, start, kGap);
        std::vector<Phase> run;
        for (std::size_t k = 0; k < intervals(); ++k) {
            const double length = path[k].length;
            knots_[k].v = std::sqrt(found[k].q);
            knots_[k].a = found[k].a;
            const double v1 = std::sqrt(found[k + 1].q);
            double duration = 3 * length / std::max(knots_[k].v, v1);
            if (k > 0 && k + 1 < intervals()) {
                const double bend = (found[k + 1].a - found[k].a) / length;
                const auto slowness = [&](double x) {
                    return 1 / std::sqrt(found[k].q + (2 * found[k].a + bend * x) * x);
                };
                duration =
                    boost::math::quadrature::gauss<double, 10>::integrate(slowness, 0., length);
            }
            run.push_back(phase_of(knots_[k].s, length, knots_[k].v, v1, duration));
        }
        return run;
    }

    /// The move at s, which is after it begins or before it ends.
    std::size_t move_at(long double s) const {
        const auto after = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, s);
        return static_cast<std::size_t>(after - begin_.begin()) - 1;
    }

    PathInterval interval(std::size_t k) {
        const long double from = knots_[k].s;
        const long double to = knots_[k + 1].s;
        PathInterval interval;
        interval.length = static_cast<double>(to - from);
        interval.velocity = interval.end_velocity = 1e9;
        const long double inside = (to - from) * kInside;
        const std::size_t last = move_at(to - inside);
        for (std::size_t move = move_at(from + inside); move <= last; ++move) {
            interval.velocity = std::min(interval.velocity, moves_[move].velocity);
            if (move < last)
                interval.velocity = std::min(interval.velocity, moves_[move].end_velocity);
        }
        const bool joint = begin_[last + 1] < to + inside;
        if (joint) interval.end_velocity = moves_[last].end_velocity;
        // A curve may stand still at an end: nothing is asked there.
        const long double first = k == 0 ? to : from;
        const long double end = k + 1 == intervals() ? from : to;
        const long double asked[] = {first == to ? to - inside : first + inside, (first + end) / 2,
                                     end == from ? from + inside : end - inside};
        for (std::size_t i = 0; i < 3; ++i) {
            interval.limits[i] = limits(asked[i]);
            for (PlaceLimit& limit : interval.limits[i]) {
                limit.acceleration *= knots_[k].ease;
                limit.jerk *= knots_[k].ease;
            }
        }
        return interval;
    }

    std::vector<PlaceLimit> limits(long double s) {
        const std::size_t move = move_at(s);
        const RunMove& on = moves_[move];
        const PathPlace at = places_.at(on.planned, static_cast<double>(s - begin_[move]));
        std::vector<PlaceLimit> limits =
            place_limits(at, geometry_.moves[on.planned].shape, machine_);
        for (PlaceLimit& limit : limits) {
            limit.acceleration *= kAccelerationShare;
            limit.jerk = std::min(kJerkShare * limit.jerk, on.jerk);
        }
        return limits;
    }

    /// As few phases as keep the limits and the acceleration at their ends.
    std::vector<Phase> merged(const std::vector<Phase>& run) {
        std::vector<double> time{0};
        for (const Phase& phase : run) time.push_back(time.back() + phase.duration);
        const auto one = [&](std::size_t first, std::size_t end) {
            const bool last = end == run.size();
            const long double to = last ? knots_.back().s : run[end].s;
            return phase_of(run[first].s, static_cast<double>(to - run[first].s), run[first].v,
                            last ? 0 : run[end].v, time[end] - time[first]);
        };
        const auto fits = [&](std::size_t first, std::size_t end) {
            const Phase phase = one(first, end);
            const Phase& back = run[end - 1];
            const double off =
                phase.acceleration(phase.duration) - back.acceleration(back.duration);
            const double jump = kJump * machine_.jerk * machine_.joint_time;
            return std::abs(phase.a - run[first].a) <= jump && std::abs(off) <= jump &&
                   load(phase, first == 0, end == run.size(), static_cast<int>(end - first)) <=
                       kKept;
        };
        std::vector<Phase> phases;
        for (std::size_t first = 0; first < run.size();) {
            std::size_t good = first + 1;
            std::size_t reach = 1;
            while (good < run.size() && reach > 0) {
                const std::size_t end = std::min(run.size(), good + reach);
                if (fits(first, end)) {
                    good = end;
                    reach *= 2;
                } else {
                    reach /= 2;
                }
            }
            phases.push_back(one(first, good));
            first = good;
        }
        return phases;
    }

    /// Worst ratio to a limit of one phase, on the true path.
    double load(const Phase& phase, bool first, bool last, int intervals) {
        double worst = 0;
        if (!std::isfinite(phase.duration)) return kSplit;
        const int places = kPlaces * intervals;
        // Just within the ends; where the curve may stand still, not there at all.
        for (int i = first ? 1 : 0; i <= places - (last ? 1 : 0); ++i) {
            const double part = i == 0 ? kInside : i == places ? 1 - kInside : 1. * i / places;
            const double t = phase.duration * part;
            const long double s = phase.place(t);
            const double v = phase.speed(t);
            const double a = phase.acceleration(t);
            worst = std::max(worst, v / moves_[move_at(s)].velocity);
            for (const PlaceLimit& limit : limits(s)) {
                worst = std::max({worst, acceleration_of(limit, v, a) / limit.acceleration,
                                  jerk_of(limit, v, a, phase.j) / limit.jerk});
            }
        }
        return worst;
    }

    /// Else splits intervals in which the path changes too much, or eases their limits.
    bool keeps(const std::vector<Phase>& run) {
        bool kept = true;
        std::vector<RunKnot> knots;
        for (std::size_t k = 0; k < intervals(); ++k) {
            knots.push_back(knots_[k]);
            const double ratio = load(run[k], k == 0, k + 1 == intervals(), 1);
            if (ratio <= kKept) continue;
            kept = false;
            const bool long_enough = !(run[k].duration < 2 * kShortest);
            if (ratio < kSplit || !long_enough || k == 0 || k + 1 == intervals()) {
                knots.back().ease /= std::min(ratio, kSplit);
            } else {
                const RunKnot& from = knots_[k];
                const RunKnot& to = knots_[k + 1];
                knots.push_back({(from.s + to.s) / 2,
                                 std::sqrt((from.v * from.v + to.v * to.v) / 2),
                                 (from.a + to.a) / 2, from.ease});
            }
        }
        knots.push_back(knots_.back());
        knots_ = std::move(knots);
        return kept;
    }

    const std::vector<RunMove>& moves_;
    const Geometry& geometry_;
    const Machine& machine_;
    PathPlaces& places_;
    std::vector<long double> begin_;  // of moves, mm
    std::vector<RunKnot> knots_;
};

}  // namespace

std::vector<Phase> optimal_run(const std::vector<Phase>& phases, const std::vector<RunMove>& moves,
                               const Geometry& geometry, const Machine& machine,
                               PathPlaces& places) {
    return OptimalRun(moves, geometry, machine, places).run(phases);
}

}  // namespace curvecore::ref
