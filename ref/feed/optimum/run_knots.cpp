// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/run_knots.hpp"

#include <algorithm>

namespace curvecore::ref {
namespace {

constexpr double kSliver = 0.3;  // share of a step: knots nearer to a joint are left out
constexpr int kLeastKnots = 16;
constexpr double kFastest = 0.995;  // share of a move's velocity: no optimum is faster

class Knots {
  public:
    Knots(const std::vector<Phase>& phases, const std::vector<RunMove>& moves)
        : phases_(phases), moves_(moves) {
        double time = 0;
        for (const Phase& phase : phases) {
            start_.push_back(time);
            time += phase.duration;
        }
        start_.push_back(time);
    }

    std::vector<RunKnot> run() {
        const double total = start_.back();
        std::vector<double> joints;
        long double s = 0;
        for (const RunMove& move : moves_) {
            s += move.length;
            if (&move != &moves_.back()) joints.push_back(time_of(s));
        }
        joints.push_back(total);
        std::vector<RunKnot> knots{at(0)};
        double t = 0;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const double joint = joints[i];
            const double step = std::min(moves_[i].step, total / kLeastKnots);
            for (double next = t;
                 (next += std::max(step, cruise_step(next, moves_[i]))) < joint - kSliver * step;) {
                knots.push_back(at(t = next));
            }
            const bool apart = joint - t >= kSliver * step && total - joint >= kSliver * step;
            if (apart) knots.push_back(at(t = joint));
        }
        knots.push_back({s, end_speed(phases_), 0});
        return knots;
    }

  private:
    std::size_t phase(double t) const {
        const auto next = std::upper_bound(start_.begin(), start_.end() - 1, t);
        return static_cast<std::size_t>(next - start_.begin()) - 1;
    }
    RunKnot at(double t) const {
        const std::size_t i = phase(t);
        const Phase& p = phases_[i];
        const double x = t - start_[i];
        return {p.place(x), std::max(0.0, p.speed(x)), p.acceleration(x)};
    }
    double time_of(long double s) const {
        const auto after =
            std::upper_bound(phases_.begin(), phases_.end(), s,
                             [](long double at, const Phase& p) { return at < p.s; });
        const std::size_t i = static_cast<std::size_t>(after - phases_.begin()) - 1;
        double low = 0;
        double high = phases_[i].duration;
        for (int k = 0; k < 60 && high - low > 1e-15; ++k) {
            const double middle = (low + high) / 2;
            (at(start_[i] + middle).s < s ? low : high) = middle;
        }
        return start_[i] + low;
    }
    /// Step of knots where the speed is constant: the farther the ends of that part, the larger; if
    /// the move allows more speed, the path's bends still count.
    double cruise_step(double t, const RunMove& move) const {
        const std::size_t i = phase(t);
        if (phases_[i].a != 0 || phases_[i].j != 0) return 0;
        const bool fastest = phases_[i].v >= kFastest * move.velocity;
        return std::min({t - start_[i], (start_[i + 1] - t) / 2,
                         fastest ? start_.back() : move.widest * move.step});
    }

    const std::vector<Phase>& phases_;
    const std::vector<RunMove>& moves_;
    std::vector<double> start_;
};

}  // namespace

std::vector<RunKnot> run_knots(const std::vector<Phase>& phases,
                               const std::vector<RunMove>& moves) {
    return Knots(phases, moves).run();
}

}  // namespace curvecore::ref
