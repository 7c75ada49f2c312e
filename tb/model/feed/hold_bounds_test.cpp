// SPDX-License-Identifier: Apache-2.0
// Bounds of holds before anything is planned: of what path and axes can take together.
#include "ref/feed/stops/hold_bounds.hpp"

#include <gtest/gtest.h>

namespace curvecore::tb {
namespace {

/// Ticks of a stop from 50 mm/s on slow axes.
std::uint32_t stop_ticks(double path_acceleration, double path_jerk, double unused) {
    ref::Machine machine;
    machine.velocity = 94;
    machine.acceleration = path_acceleration;
    machine.jerk = path_jerk;
    machine.axis[0].velocity = machine.axis[1].velocity = machine.axis[2].velocity = 80;
    machine.axis[0].acceleration = 79;
    machine.axis[1].acceleration = 131;
    machine.axis[2].acceleration = 154;
    machine.axis[0].jerk = machine.axis[1].jerk = 1700;
    machine.axis[2].jerk = 24000;
    machine.axis[3].acceleration = unused;
    ref::Plan plan;
    plan.unit_mm = 1e-6;
    plan.tick_s = 1e-4;
    ref::set_hold_bounds(machine, ref::PlanOptions(), 50, plan);
    return plan.stop_ticks;
}

TEST(HoldBounds, APathLimitBeyondThatOfAllAxesCostsNoTime) {
    std::uint32_t before = stop_ticks(220, 1690, 5000);
    for (const double times : {2, 4, 8, 100}) {
        const std::uint32_t ticks = stop_ticks(220 * times, 1690, 5000);
        EXPECT_LE(ticks, before) << times;
        before = ticks;
    }
    before = stop_ticks(220, 25000, 5000);
    for (const double times : {2, 4, 8, 100}) {
        const std::uint32_t ticks = stop_ticks(220, 25000 * times, 5000);
        EXPECT_LE(ticks, before) << times;
        before = ticks;
    }
}

TEST(HoldBounds, AnAxisThatTheProgramDoesNotUseCostsNoTime) {
    EXPECT_EQ(stop_ticks(220, 1690, 1), stop_ticks(220, 1690, 5000));
}

}  // namespace
}  // namespace curvecore::tb
