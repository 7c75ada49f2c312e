// SPDX-License-Identifier: Apache-2.0
// The meter of limits against motions whose changes of velocity are known.
#include "sysc/watch/limit_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace curvecore::tb::limit_meter_test {

using ref::Machine;
using sysc::LimitLoads;
using sysc::LimitMeter;

constexpr double kPeriod = 1e-4;
constexpr double kUnit = 1e-6;

/// Measures x(t), mm, over a second; y and z stand.
LimitLoads measure(const Machine& machine, const std::function<double(double)>& x,
                   double period = kPeriod, int per_tick = 1, double error = 0, double shake = 0) {
    LimitMeter meter(machine, kUnit, period, per_tick, 3, error);
    for (int k = 0; k * period <= 1; ++k) {
        const double off =
            shake * ((static_cast<unsigned>(k) * 2654435761U >> 16 & 1U) != 0 ? 1 : -1);
        meter.take({x(k * period) / kUnit + off, 0, 0}, 0);
    }
    return meter.finish();
}

/// A motion at the speed v from 0.5 s on, at once.
std::function<double(double)> jump(double v) {
    return [v](double t) { return v * std::max(0.0, t - 0.5); };
}

double ratio(const LimitLoads& loads, std::size_t window, std::size_t of, sysc::Limited limited) {
    return loads.windows[window].of[of][limited];
}

TEST(LimitMeter, JumpOfVelocityIsOneOfBothBounds) {
    const Machine machine;
    const LimitLoads loads = measure(machine, jump(3));
    ASSERT_EQ(loads.windows.size(), sysc::kLimitWindows.size());
    for (std::size_t i = 0; i < loads.windows.size(); ++i) {
        const double w = loads.windows[i].seconds;
        const double t = machine.joint_time;
        EXPECT_NEAR(ratio(loads, i, 0, sysc::kVelocity), 3 / machine.velocity, 1e-9);
        EXPECT_NEAR(ratio(loads, i, 0, sysc::kAcceleration), 3 / (machine.acceleration * (w + t)),
                    1e-9);
        EXPECT_NEAR(ratio(loads, i, 0, sysc::kJerk),
                    3 / (machine.jerk * w * (w + t) + machine.acceleration * t), 1e-9);
    }
    EXPECT_EQ(loads.worst[sysc::kJerk].window, 1e-3);
    EXPECT_EQ(loads.worst[sysc::kJerk].of, 0U);
}

TEST(LimitMeter, JointTimesAccelerationIsAllowedAndTwiceIsNot) {
    const Machine machine;
    const double most = machine.acceleration * machine.joint_time;
    EXPECT_LE(measure(machine, jump(most)).most(), 1);
    EXPECT_GT(measure(machine, jump(2.1 * most)).most(), 1);
}

TEST(LimitMeter, SteadyAccelerationNeedsItsShareOfEveryWindow) {
    const Machine machine;
    const double a = 0.9 * machine.acceleration;
    const auto x = [a](double t) { return t < 0.5 ? a * t * t / 2 : a / 4 * (t - 0.25); };
    const LimitLoads loads = measure(machine, x);
    for (std::size_t i = 0; i < loads.windows.size(); ++i) {
        const double w = loads.windows[i].seconds;
        EXPECT_GE(ratio(loads, i, 0, sysc::kAcceleration),
                  0.9 * w / (w + machine.joint_time) - 1e-9);
    }
    EXPECT_GT(loads.worst[sysc::kVelocity].ratio, 1) << "a quarter of 4500 mm/s";
}

TEST(LimitMeter, AxisWithATighterLimitIsTheWorst) {
    Machine machine;
    machine.axis[0].jerk /= 4;
    machine.axis[0].acceleration /= 4;
    const LimitLoads loads = measure(machine, jump(3));
    EXPECT_EQ(loads.worst[sysc::kJerk].of, 1U);
    EXPECT_NEAR(ratio(loads, 0, 1, sysc::kAcceleration) / ratio(loads, 0, 0, sysc::kAcceleration),
                4, 1e-9);
    EXPECT_EQ(ratio(loads, 0, 2, sysc::kAcceleration), 0);
}

TEST(LimitMeter, DenserSamplesSayTheSame) {
    const Machine machine;
    const LimitLoads coarse = measure(machine, jump(3));
    const LimitLoads fine = measure(machine, jump(3), 1e-6);
    for (std::size_t i = 0; i < coarse.windows.size(); ++i) {
        EXPECT_NEAR(ratio(fine, i, 0, sysc::kJerk), ratio(coarse, i, 0, sysc::kJerk), 1e-6);
    }
}

TEST(LimitMeter, WindowBelowFourTicksIsNotResolved) {
    const Machine machine;
    const auto resolved = [&](double period, int per_tick) {
        const LimitLoads loads = measure(machine, jump(3), period, per_tick);
        return std::count_if(loads.windows.begin(), loads.windows.end(),
                             [](const sysc::WindowLoads& window) { return !window.of.empty(); });
    };
    EXPECT_EQ(resolved(2.5e-4, 1), 5);
    EXPECT_EQ(resolved(2.6e-4, 1), 4);
    EXPECT_EQ(resolved(2.5e-4, 2), 4);
    EXPECT_EQ(resolved(5e-3, 1), 1);
    EXPECT_FALSE(measure(machine, jump(3), 6e-3).resolved());
}

TEST(LimitMeter, RoundingIsAllowedForAndStated) {
    const Machine machine;
    constexpr double kError = 0.5;  // units, on every sample to either side
    const auto still = [](double) { return 0.0; };
    const LimitLoads loads = measure(machine, still, kPeriod, 1, kError, kError);
    const double jerk_window = machine.jerk * 1e-3 * 2e-3 + machine.acceleration * 1e-3;
    const double rounding = std::sqrt(3.0) * 8 * kError * kUnit / kPeriod;
    EXPECT_NEAR(loads.rounding(), rounding / (jerk_window + rounding), 1e-9);
    // Zero limits: the rounding takes all of the allowance.
    Machine none;
    none.acceleration = none.jerk = 1e-9;
    for (ref::AxisLimits& axis : none.axis) axis.acceleration = axis.jerk = 1e-9;
    EXPECT_LE(measure(none, still, kPeriod, 1, kError, kError).most(), 1);
    EXPECT_GT(measure(none, still, kPeriod, 1, kError / 2, kError).most(), 1);
}

TEST(LimitMeter, SaysWhereTheWorstIs) {
    const Machine machine;
    LimitMeter meter(machine, kUnit, kPeriod, 1, 3);
    for (int k = 0; k <= 10000; ++k) {
        const double t = std::max(0.0, k * kPeriod - 0.5);  // 3 mm/s at once, then ever slower
        meter.take({0.3 * (1 - std::exp(-10 * t)) / kUnit, 0, 0}, k <= 5000 ? 1 : 2);
    }
    const LimitLoads loads = meter.finish();
    EXPECT_EQ(loads.worst[sysc::kAcceleration].segment, 2U);
    EXPECT_NEAR(static_cast<double>(loads.worst[sysc::kAcceleration].sample), 5001, 11);
}

}  // namespace curvecore::tb::limit_meter_test
