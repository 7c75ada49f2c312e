// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/ramps/phase.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kSliver = 1e-11;  // s, of a phase, at a place where it begins or ends

}  // namespace

Phase phase_between(long double s, double length, double v0, double v1, double duration) {
    Phase phase;
    phase.duration = duration;
    phase.s = s;
    phase.v = v0;
    phase.a = (6 * length / duration - 4 * v0 - 2 * v1) / duration;
    phase.j = (6 * (v0 + v1) - 12 * length / duration) / (duration * duration);
    return phase;
}

double duration(const std::vector<Phase>& phases) {
    double time = 0;
    for (const Phase& phase : phases) time += phase.duration;
    return time;
}

double end_speed(const std::vector<Phase>& phases) {
    const double v = phases.back().speed(phases.back().duration);
    return v < kAtRest ? 0 : v;
}

double time_at(const Phase& phase, double from, double s) {
    const double exact = 1e-13 + 1e-15 * phase.duration;
    double low = from;
    double high = phase.duration;
    double t = low;
    while (high - low > exact) {
        const double miss = static_cast<double>(phase.place(t)) - s;
        (miss < 0 ? low : high) = t;
        const double v = std::max(0.0, phase.speed(t));
        const double newton = v > 0 ? t - miss / v : high;
        const double next = newton > low && newton < high ? newton : low + (high - low) / 2;
        if (std::abs(next - t) < exact) break;
        t = next;
    }
    return t;
}

std::vector<Phase> part_of(const std::vector<Phase>& phases, long double from, long double to) {
    std::vector<Phase> part;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const Phase& phase = phases[i];
        const long double end =
            i + 1 < phases.size() ? phases[i + 1].s : phase.place(phase.duration);
        if (end <= from || phase.s >= to) continue;
        Phase local = phase;  // the phase with small numbers as places
        local.s -= from;
        const double t0 = phase.s < from ? time_at(local, 0, 0) : 0;
        const double t1 =
            end > to ? time_at(local, t0, static_cast<double>(to - from)) : phase.duration;
        if (t1 - t0 < kSliver) continue;
        part.push_back(
            {t1 - t0, local.place(t0), local.speed(t0), local.acceleration(t0), local.j});
    }
    if (!part.empty()) part.front().s = 0;
    return part;
}

void append_motion(std::vector<Phase>& phases, const std::vector<Phase>& part, long double s) {
    for (Phase phase : part) {
        phase.s += s;
        phases.push_back(phase);
    }
}

}  // namespace curvecore::ref
