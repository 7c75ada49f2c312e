// SPDX-License-Identifier: Apache-2.0
// Execution of a stop branch: as the hardware's words draw it, and in real numbers.
#pragma once

#include "ref/feed/stops/stop_branch.hpp"
#include "tb/support/judge/tick_run.hpp"

namespace curvecore::tb {

/// Calls tick(rate, 2^-32) for every tick of a stop; returns whether it ends at rest.
template <class Tick>
bool each_rate(const ref::StopSteps& steps, Tick tick) {
    std::int64_t rate = std::int64_t{1} << 32;
    std::int64_t slope = 0;
    for (const ref::StopStep& step : steps) {
        for (std::uint32_t i = 0; i < step.ticks; ++i) {
            slope += step.change;
            rate += slope;
            tick(rate);
        }
    }
    return rate == 0 && slope == 0;
}

/// Measures over windows the whole plan up to a tick and the stop, by the kernel; `late`: part of a
/// tick by which the stop begins later, 2^-16, as after a hold.
inline sysc::LimitLoads stopped_limits(const ref::Plan& plan, const ref::Machine& machine,
                                       std::uint64_t tick, const ref::StopSteps& steps,
                                       std::int32_t late = 0) {
    TickRun run(plan, machine);
    if (late > 0) run.tick(late);
    for (std::uint64_t k = 0; k < tick; ++k) run.tick(1 << 16);
    each_rate(steps, [&](std::int64_t rate) { run.tick(static_cast<std::int32_t>(rate >> 16)); });
    for (int k = 0; k < 400; ++k) run.tick(0);
    return run.finish();
}

/// Worst acceleration and jerk of X Y Z during the stop over the machine's, from differences of
/// places `step` ticks apart: means over 2 and 3 of them, without the allowance for joints.
struct Differences {
    double acceleration = 0;
    double jerk = 0;
};
inline Differences stopped_differences(const ref::Plan& plan, const ref::Machine& machine,
                                       std::uint64_t tick, const ref::StopSteps& steps,
                                       std::size_t step) {
    ref::CurveFollower curve;
    std::vector<ref::Vec3> places;
    auto segment = plan.segments.begin();
    std::size_t piece = 0;
    double start = 0;  // start of the piece, ticks
    std::uint64_t done = 0;
    double time = 0;
    const auto place = [&] {
        while (piece < plan.pieces.size() && time >= start + plan.pieces[piece].ticks) {
            start += plan.pieces[piece].ticks;
            done += plan.pieces[piece++].ds;
        }
        double s = static_cast<double>(done);
        if (piece < plan.pieces.size()) s += piece_state(plan.pieces[piece], time - start).s;
        while (segment + 1 != plan.segments.end() &&
               s > static_cast<double>(segment->s_start + segment->length)) {
            ++segment;
        }
        const double local = std::ldexp(s - static_cast<double>(segment->s_start), -16);
        places.push_back(curve.on(*segment).position(local) * plan.unit_mm);
    };
    place();
    for (std::uint64_t k = 0; k < tick; ++k, time += 1, place()) {
    }
    each_rate(steps, [&](std::int64_t rate) {
        time += std::ldexp(static_cast<double>(rate), -32);
        place();
    });
    Differences worst;
    const double h = static_cast<double>(step) * plan.tick_s;
    const std::size_t first = tick > 3 * step ? tick - 3 * step : 0;
    for (std::size_t i = first; i + 3 * step < places.size(); ++i) {
        const ref::Vec3& a = places[i];
        const ref::Vec3& b = places[i + step];
        const ref::Vec3& c = places[i + 2 * step];
        const ref::Vec3& d = places[i + 3 * step];
        worst.acceleration =
            std::max(worst.acceleration, (c - 2 * b + a).norm() / (h * h * machine.acceleration));
        worst.jerk =
            std::max(worst.jerk, (d - 3 * c + 3 * b - a).norm() / (h * h * h * machine.jerk));
    }
    return worst;
}

}  // namespace curvecore::tb
