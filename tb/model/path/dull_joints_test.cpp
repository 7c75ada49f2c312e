// SPDX-License-Identifier: Apache-2.0
// Long lines that meet at dull angles: the jerk of the drawn motion, by third differences of its
// positions alone. A third difference over h is a mean of the jerk over 3 h.
#include <gtest/gtest.h>

#include <cmath>

#include "ref/feed/planner.hpp"
#include "ref/path/smooth_path.hpp"
#include "tb/support/judge/drawn_limits.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::dull_joints_test {

using ref::Vec3;

constexpr double kPeriod = 100e-6;  // s, of a sample

std::vector<Vec3> drawn_positions(const ref::Plan& plan) {
    const std::uint64_t samples = sysc::count_samples(plan, 0, 1 << 16);
    sysc::PathSource source(plan, 0, 1 << 16);
    sysc::PathCursor cursor(plan);
    ref::CurveFollower curve;
    std::vector<Vec3> positions;
    for (std::uint64_t k = 0; k < samples; ++k) {
        positions.push_back(plan.unit_mm * curve.on(cursor.segment()).position(cursor.local()));
        source.next();
        cursor.advance(static_cast<std::uint64_t>(source.ds()));
    }
    return positions;
}

/// Worst jerk of the path and its axes, over three times h samples.
double worst_jerk(const std::vector<Vec3>& p, std::size_t h) {
    double worst = 0;
    for (std::size_t i = 3 * h; i < p.size(); ++i) {
        const Vec3 third = p[i] - 3 * p[i - h] + 3 * p[i - 2 * h] - p[i - 3 * h];
        worst = std::max(worst, third.norm());
    }
    return worst / std::pow(static_cast<double>(h) * kPeriod, 3);
}

/// A square corner, `lines` lines with a turn between each and the next, a square corner.
ref::Program dull_lines(double length, double turn, int lines, double feed) {
    ProgramBuilder builder;
    builder.line({0, -20, 0}, feed);
    for (int i = 0; i < lines; ++i) {
        const double way = turn * (i % 2);
        builder.line(builder.at() + length * Vec3(std::cos(way), std::sin(way), 0), feed);
    }
    builder.line(builder.at() + Vec3(0, 20, 0), feed);
    return builder.program();
}

class DullJoints : public testing::TestWithParam<double> {};  // degrees
INSTANTIATE_TEST_SUITE_P(Turns, DullJoints, testing::Values(0.1, 0.2, 0.46, 1., 2., 5.),
                         [](const auto& turn) {
                             return std::to_string(std::lround(turn.param * 1e3)) + "_millidegrees";
                         });

TEST_P(DullJoints, AreRoundedWithWhatTheyNeed) {
    const ref::Machine machine;
    const double turn = GetParam() * M_PI / 180;
    for (const double length : {9., 20., 50.}) {
        for (const double tolerance : {0.002, 0.01, 0.05}) {
            for (const double feed : {60., 20000 / 60.}) {
                const ref::Program exact =
                    with_tolerance(dull_lines(length, turn, 3, feed), tolerance);
                ref::Program program = exact;
                const ref::Smoothed smoothed = ref::smooth_path(program, machine);
                EXPECT_LE(smoothed.share, 1 + 1e-12);
                const std::vector<Vec3> drawn = drawn_positions(make_plan(program, machine, {}));
                EXPECT_LE((drawn.back() - program.moves.back().end).norm(), 1e-3);
                for (const auto& [ticks, most] : {std::pair{10, 1.25}, {20, 1.1}, {50, 1.0}}) {
                    EXPECT_LE(worst_jerk(drawn, static_cast<std::size_t>(ticks)) / machine.jerk,
                              most)
                        << length << " mm, " << tolerance << " mm, " << feed << " mm/s, over 3 x "
                        << ticks << " samples";
                }
            }
        }
    }
}

}  // namespace curvecore::tb::dull_joints_test
