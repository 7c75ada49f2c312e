// SPDX-License-Identifier: Apache-2.0
// The tool that swings behind its drives against closed forms: a mass behind a drive that starts,
// a circle's radius, and what shapers leave.
#include "sysc/watch/tool_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace curvecore::tb::tool_meter_test {

using sysc::SwingingMass;
using sysc::ToolMeter;
using sysc::ToolResult;

constexpr double kPeriod = 1e-4;  // s
constexpr double kUnit = 1e-6;    // mm
constexpr double kHertz = 40;
constexpr double kOmega = 2 * M_PI * kHertz;

TEST(SwingingMass, SwingsBehindADriveThatStarts) {
    for (const double damping : {0.0, 0.05, 0.5}) {
        SwingingMass mass({kHertz, damping}, kPeriod, 0);
        const double root = std::sqrt(1 - damping * damping);
        const double lag = 2 * damping / kOmega;
        for (int n = 1; n < 2000; ++n) {
            const double t = n * kPeriod;
            const double swing = std::exp(-damping * kOmega * t);
            // x'' = w^2 (t - x) - 2 z w x' from rest
            const double exact = t - lag +
                                 swing * (lag * std::cos(kOmega * root * t) +
                                          (2 * damping * damping - 1) / (kOmega * root) *
                                              std::sin(kOmega * root * t));
            ASSERT_NEAR(mass.follow(t), exact, 1e-12) << damping << " " << n;
        }
    }
}

ref::Machine machine(ref::ShaperKind kind, double damping) {
    ref::Machine machine;
    machine.shaper = kind;
    for (std::size_t axis = 0; axis < 2; ++axis) machine.modes[axis] = {kHertz, damping};
    return machine;
}

/// Calls visit(point) along six turns of a circle of 5 mm, `hertz` of them a second, into which and
/// out of which a spiral leads as smoothly as a sine.
template <class Visit>
void circles(double hertz, Visit visit) {
    ToolMeter::Point point{};
    const double seconds = 6 / hertz;
    for (int n = 0; n * kPeriod <= seconds; ++n) {
        const double part = n * kPeriod / seconds;
        const double in = std::min({1.0, 3 * part, 3 * (1 - part)});
        const double radius = 5 / kUnit * (in - std::sin(2 * M_PI * in) / (2 * M_PI));
        const double angle = 2 * M_PI * hertz * n * kPeriod;
        point[0] = radius * std::cos(angle);
        point[1] = radius * std::sin(angle);
        visit(point);
    }
}
ToolResult circles(ref::ShaperKind kind, double damping, double hertz) {
    ToolMeter meter(machine(kind, damping), kUnit, kPeriod, 1, 3);
    circles(hertz, [&](const ToolMeter::Point& point) { meter.take(point, 0); });
    return meter.finish();
}

TEST(ToolMeter, ACircleIsLargerByTheModesResponse) {
    for (const double damping : {0.01, 0.1}) {
        const double hertz = 2;
        const ToolResult result = circles(ref::ShaperKind::kNone, damping, hertz);
        // 1 / |1 - (f / f0)^2 + 2 i z f / f0|
        const double share = hertz / kHertz;
        const double gain = 1 / std::hypot(1 - share * share, 2 * damping * share);
        EXPECT_NEAR(result.without.off, 5 * (gain - 1), 0.03 * 5 * (gain - 1)) << damping;
        EXPECT_LT(result.without.rest, 1e-3);
    }
}

TEST(ToolMeter, FeedForwardHasTheToolOnThePath) {
    const ToolResult result = circles(ref::ShaperKind::kFeedForward, 0.05, 2);
    EXPECT_LT(result.shaped.off, result.without.off / 20);
    const auto taps = ref::shaper_taps(machine(ref::ShaperKind::kFeedForward, 0.05), kPeriod,
                                       ToolMeter::kMostDelay);
    EXPECT_DOUBLE_EQ(result.delay_s, taps[0].delay * kPeriod);
}

/// An axis without a mode is on the path, however late the others are with impulses.
TEST(ToolMeter, ARigidAxisIsOnThePathBesideOneThatIsLate) {
    ToolMeter meter(machine(ref::ShaperKind::kZv, 0.05), kUnit, kPeriod, 1, 3);
    ToolMeter::Point point{};
    for (int n = 0; n < 5000; ++n) {
        point[2] = n * 100e3 * kPeriod / kUnit * 1e-3;
        meter.take(point, 0);
    }
    const ToolResult result = meter.finish();
    EXPECT_LT(result.without.off, 1e-9);
    EXPECT_LT(result.shaped.off, 1e-9);
    EXPECT_LT(result.shaped.rest, 1e-9);
    EXPECT_GT(result.delay_s, 40 * kPeriod);
}

/// Steps to a place at once: ZV leaves nothing of the swing, EI a twentieth, at most.
TEST(ToolMeter, ImpulsesLeaveTheToolAtRest) {
    const std::pair<ref::ShaperKind, double> most[] = {{ref::ShaperKind::kZv, 1e-3},
                                                       {ref::ShaperKind::kEi, 0.0501}};
    for (const auto& [kind, left] : most) {
        ToolMeter meter(machine(kind, 0), kUnit, kPeriod, 1, 3);
        ToolMeter::Point point{};
        meter.take(point, 0);
        point[0] = 1 / kUnit;
        meter.take(point, 0);
        const ToolResult result = meter.finish();
        EXPECT_NEAR(result.without.rest, 1, 1e-3);
        EXPECT_LT(result.shaped.rest, left);
    }
}

/// The drives are asked for the path's motion by the gain of feed-forward, the mode's inverse.
TEST(ToolMeter, DrivesAreAskedForTheModesInverse) {
    const double hertz = 8;
    const double damping = 0.3;
    sysc::LimitMeter path(machine(ref::ShaperKind::kFeedForward, damping), kUnit, kPeriod, 1, 3);
    circles(hertz, [&](const ToolMeter::Point& point) { path.take(point, 0); });
    const double asked = path.finish().worst[sysc::kAcceleration].ratio;
    const ToolResult result = circles(ref::ShaperKind::kFeedForward, damping, hertz);
    const double share = hertz / kHertz;
    const double gain = std::hypot(1 - share * share, 2 * damping * share);
    EXPECT_NEAR(result.drives.worst[sysc::kAcceleration].ratio / asked, gain, 0.01);
}

}  // namespace curvecore::tb::tool_meter_test
