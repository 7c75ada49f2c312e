// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/optimum/merged_phases.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kJump = 0.3;  // share of jerk * JointTime: change of acceleration between phases
constexpr double kLoadKept = 1.04;  // share of a limit's share, before words are rounded
constexpr double kSpeedKept = 1.001;
constexpr double kRestSpeed = 1e-9;  // mm/s, rounding of a rest

/// Least speed, mm/s; s(t) never goes back.
double least_speed(const Phase& phase) {
    const double bend = phase.j != 0 ? -phase.a / phase.j : -1;
    const double inside = bend > 0 && bend < phase.duration ? phase.speed(bend) : phase.v;
    return std::min({phase.v, inside, phase.speed(phase.duration)});
}

class Merger {
  public:
    Merger(const std::vector<Phase>& run, const std::vector<int>& mends, const RunPath& path,
           const Machine& machine)
        : run_(run), mends_(mends), path_(path), jump_time_(kJump * machine.joint_time) {
        time_.push_back(0);
        for (const Phase& phase : run) time_.push_back(time_.back() + phase.duration);
    }

    std::vector<Phase> merge() {
        std::vector<Phase> phases;
        for (std::size_t first = 0; first < run_.size();) {
            std::size_t good = first + 1;
            std::size_t reach = 1;
            while (good < run_.size() && reach > 0) {
                const std::size_t end = std::min(run_.size(), good + reach);
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

  private:
    Phase one(std::size_t first, std::size_t end) const {
        const Phase& back = run_[end - 1];
        const long double to = back.place(back.duration);
        const double v = end == run_.size() ? end_speed(run_) : run_[end].v;
        return phase_between(run_[first].s, static_cast<double>(to - run_[first].s), run_[first].v,
                             v, time_[end] - time_[first]);
    }

    /// Largest jump of acceleration at a knot.
    double jump(std::size_t knot) const { return jump_time_ * path_.jerk_along(knot); }

    bool fits(std::size_t first, std::size_t end) {
        const auto at = [this](std::size_t i) {
            return mends_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (std::any_of(at(first), at(end), [](int mends) { return mends > 0; })) return false;
        const Phase phase = one(first, end);
        const Phase& back = run_[end - 1];
        const double off = phase.acceleration(phase.duration) - back.acceleration(back.duration);
        if (std::abs(phase.a - run_[first].a) > jump(first) || std::abs(off) > jump(end)) {
            return false;
        }
        if (least_speed(phase) < -kRestSpeed) return false;
        const RunLoads loads = path_.loads(phase, first, end, {kLoadKept, kSpeedKept});
        return loads.load <= kLoadKept && loads.speed <= kSpeedKept;
    }

    const std::vector<Phase>& run_;
    const std::vector<int>& mends_;
    const RunPath& path_;
    double jump_time_;
    std::vector<double> time_;
};

}  // namespace

std::vector<Phase> merged_phases(const std::vector<Phase>& run, const std::vector<int>& mends,
                                 const RunPath& path, const Machine& machine) {
    return Merger(run, mends, path, machine).merge();
}

}  // namespace curvecore::ref
