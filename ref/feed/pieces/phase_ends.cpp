// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/pieces/phase_ends.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kApart = 0.3;  // ticks between ends, at least

/// Path, mm, and speed, mm/s, at a time, s.
struct End {
    long double time;
    long double s;
    double v;
    bool moved;
};

}  // namespace

PhaseEnds::PhaseEnds(const std::vector<Phase>& phases, double tick) : phases_(phases) {
    long double time = 0;
    times_.push_back(time);
    for (const Phase& phase : phases) times_.push_back(time += phase.duration);
    ticks_ = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::ceil(time / tick * (1 - 1e-12L))));
    tick_ = time / ticks_;
}

std::uint64_t PhaseEnds::nearest(std::size_t end) const {
    return static_cast<std::uint64_t>(std::llround(times_[end] / tick_));
}

std::vector<Phase> PhaseEnds::moved(const std::vector<std::size_t>& ends) const {
    std::vector<End> all;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
        all.push_back({times_[i], phases_[i].s, phases_[i].v, false});
    }
    const Phase& last = phases_.back();
    all.push_back({times_.back(), last.place(last.duration), end_speed(phases_), false});
    for (const std::size_t i : ends) {
        const std::uint64_t tick = nearest(i);
        const long double time = (times_[i] > tick * tick_ ? tick + 1 : tick - 1) * tick_;
        if (time < std::max(all[i - 1].time, times_[i - 1]) + kApart * tick_ ||
            time > times_[i + 1] - kApart * tick_) {
            continue;
        }
        const std::size_t on = time < times_[i] ? i - 1 : i;
        const auto t = static_cast<double>(time - times_[on]);
        all[i] = {time, phases_[on].place(t), phases_[on].speed(t), true};
    }
    std::vector<Phase> phases = phases_;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const End& from = all[i];
        const End& to = all[i + 1];
        if (!from.moved && !to.moved) continue;
        phases[i] = phase_between(from.s, static_cast<double>(to.s - from.s), from.v, to.v,
                                  static_cast<double>(to.time - from.time));
    }
    return phases;
}

}  // namespace curvecore::ref
