// SPDX-License-Identifier: Apache-2.0
#include "sysc/steps/drive_axis.hpp"

#include <gtest/gtest.h>

namespace curvecore::tb::drive_axis_test {

using sysc::AxisSettings;
using sysc::DriveAxis;

constexpr double kStep = 1e-3;      // mm
constexpr double kPeriod = 100e-6;  // s

AxisSettings settings(double damping, double friction) {
    AxisSettings axis;
    axis.frequency_hz = 40;
    axis.damping = damping;
    axis.friction = friction;
    axis.encoder_mm = 1e-6;
    return axis;
}

TEST(DriveAxis, FollowsAConstantSpeedByDampingAndFriction) {
    for (const double damping : {0.5, 1.0}) {
        for (const double friction : {0.0, 50.0}) {
            const AxisSettings axis = settings(damping, friction);
            DriveAxis drive(axis, kStep, kPeriod);
            for (int n = 0; n < 10000; ++n) {
                for (int step = 0; step < 10; ++step) drive.step(false);
                drive.advance();
            }
            const double omega = 2 * M_PI * axis.frequency_hz;
            const double speed = 10 * kStep / kPeriod;
            const double behind = 2 * damping * speed / omega + friction / (omega * omega);
            EXPECT_NEAR(drive.following_error(), behind, 0.02 * behind) << damping;
        }
    }
}

/// Overshoot with damping, by the equation; undamped the axis would oscillate.
TEST(DriveAxis, OvershootsAStepAsTheEquationDoes) {
    const double damping = 0.3;
    DriveAxis drive(settings(damping, 0), kStep, kPeriod);
    for (int step = 0; step < 1000; ++step) drive.step(true);
    double least = 0;
    double most = 0;
    for (int n = 0; n < 2000; ++n) {
        drive.advance();
        least = std::min(least, drive.following_error());
        most = std::max(most, drive.following_error());
    }
    EXPECT_LE(drive.worst_following_error(), 1.0);
    EXPECT_NEAR(most, std::exp(-M_PI * damping / std::sqrt(1 - damping * damping)), 0.02);
    EXPECT_LT(least, -0.9);
}

/// A step that the drive feels less than the friction does not move the axis.
TEST(DriveAxis, SticksBelowTheFriction) {
    const AxisSettings axis = settings(0.7, 100);
    const double omega = 2 * M_PI * axis.frequency_hz;
    DriveAxis drive(axis, kStep, kPeriod);
    int stuck = 0;
    for (; stuck < 10 && drive.following_error() == stuck * kStep; ++stuck) {
        drive.step(false);
        for (int n = 0; n < 100; ++n) drive.advance();
    }
    EXPECT_EQ(stuck - 1, static_cast<int>(axis.friction / (omega * omega) / kStep));
}

}  // namespace curvecore::tb::drive_axis_test
