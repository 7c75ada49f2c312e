// SPDX-License-Identifier: Apache-2.0
// Paths that G64 P makes of programs: smooth, and within the tolerance by an independent search of
// both paths.
#include "ref/path/smooth_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ref/curve/cubic.hpp"
#include "ref/path/corner.hpp"
#include "tb/support/judge/frechet.hpp"
#include "tb/support/programs/chopped_curves.hpp"
#include "tb/support/programs/random_lines.hpp"

namespace curvecore::tb::smooth_path_test {

using ref::Move;
using ref::Program;
using ref::Smoothed;
using ref::Vec3;

/// Worst jumps at joints that do not stop.
struct Jumps {
    double place = 0;  // mm
    double turn = 0;   // rad
    double bend = 0;   // 1/mm
};

Jumps jumps(const Program& program) {
    Jumps worst;
    for (std::size_t i = 1; i < program.moves.size(); ++i) {
        const ref::MovePlace before =
            ref::place_on(program.moves[i - 1], program.moves[i - 1].length());
        const ref::MovePlace after = ref::place_on(program.moves[i], 0);
        worst.place = std::max(worst.place, (after.position - before.position).norm());
        worst.turn = std::max(worst.turn, (after.tangent - before.tangent).norm());
        worst.bend = std::max(worst.bend, (after.curvature - before.curvature).norm());
    }
    return worst;
}

/// Smooths a program and searches for its greatest distance from the original, as a share of the
/// tolerance.
double smooth_and_search(Program& program, Smoothed& smoothed) {
    const double tolerance = program.moves.front().tolerance;
    const std::vector<Move> programmed = program.moves;
    smoothed = ref::smooth_path(program, ref::Machine());
    EXPECT_LE(smoothed.share, 1 + 1e-12);
    const double fine = tolerance / 2000;
    return frechet(polyline(programmed, fine), polyline(program.moves, fine), 1.01 * tolerance) /
           tolerance;
}

TEST(Frechet, OfAStepAsideIsTheStep) {
    const Polyline straight{{0, 0, 0}, {10, 0, 0}};
    const Polyline aside{{0, 0, 0}, {4, 0, 0}, {4, 0.3, 0}, {6, 0.3, 0}, {6, 0, 0}, {10, 0, 0}};
    EXPECT_NEAR(frechet(straight, aside, 1), 0.3, 1e-3);
    EXPECT_NEAR(frechet(aside, straight, 1), 0.3, 1e-3);
}

TEST(Frechet, SeesAWalkBack) {
    const Polyline straight{{0, 0, 0}, {10, 0, 0}};
    const Polyline back{{0, 0, 0}, {6, 0, 0}, {4, 0, 0}, {10, 0, 0}};
    EXPECT_NEAR(frechet(straight, back, 2), 1, 2e-3);
}

TEST(SmoothPath, OfASquareCornerIsTheCubicWithTheWholeTolerance) {
    for (const double turn : {0.4, M_PI / 4, M_PI / 2, 2.0, 2.55}) {
        ProgramBuilder builder;
        builder.line({10, 0, 0}, 100);
        builder.line({10 + 10 * std::cos(turn), 10 * std::sin(turn), 0}, 100);
        Program program = with_tolerance(builder.program(), 0.05);
        Smoothed smoothed;
        EXPECT_NEAR(smooth_and_search(program, smoothed), 1, 2e-3) << turn;
        EXPECT_EQ(program.moves.size(), 3);
        EXPECT_NEAR(smoothed.share, 1, 1e-12);
        EXPECT_EQ(smoothed.line, 1);
        // (2/3) tan^2(turn / 2) / tolerance
        const double bend = 2.0 / 3 * std::pow(std::tan(turn / 2), 2) / 0.05;
        EXPECT_NEAR(ref::curvature(program.moves[1].cubic, 0.5), bend, 1e-9 * bend);
        EXPECT_LT(jumps(program).turn, 1e-12);
        EXPECT_LT(jumps(program).bend, 1e-9);
    }
}

TEST(SmoothPath, OfACornerWithAnArcIsOneCubicToo) {
    for (const double tolerance : {0.001, 0.05}) {
        for (const double turn : {-2.0, -1.0, 0.5, 1.5, 2.4}) {
            for (const double radius : {1.5, 20.0}) {
                for (const bool two_arcs : {false, true}) {
                    ProgramBuilder builder;
                    if (two_arcs) {
                        builder.arc({0, 30, 0}, {0, 0, 1}, 0.4, 0, 100);
                    } else {
                        builder.line({10, 0, 0}, 100);
                    }
                    const Vec3 in = end_tangent(builder.program().moves.back());
                    const Vec3 out = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * in;
                    builder.tangent_arc(out, Vec3::UnitZ().cross(out), radius, 1.5, 100);
                    Program program = with_tolerance(builder.program(), tolerance);
                    Smoothed smoothed;
                    const double seen = smooth_and_search(program, smoothed);
                    EXPECT_LE(seen, 1.002) << turn << " " << radius << " " << tolerance;
                    const double reach = ref::corner_reach(std::abs(turn), tolerance);
                    if (reach < 0.2 * radius) {  // beyond it is no longer near a corner of lines
                        EXPECT_GE(seen, 0.9) << turn << " " << radius << " " << tolerance;
                        EXPECT_EQ(smoothed.corners, 1) << turn << " " << radius;
                        EXPECT_EQ(program.moves.size(), 3);
                    }
                    EXPECT_LT(jumps(program).turn, 1e-9);
                    EXPECT_LT(jumps(program).bend, 1e-6);
                }
            }
        }
    }
}

TEST(SmoothPath, OfChordsIsSmooth) {
    for (const double tolerance : {0.002, 0.005, 0.02}) {
        for (const double chord : {0.02, 0.1, 0.4}) {
            for (const ChoppedCurve curve : {chopped_wave, chopped_circle}) {
                Program program = with_tolerance(curve(chord, 500), tolerance);
                const std::size_t before = program.moves.size();
                Smoothed smoothed;
                const double seen = smooth_and_search(program, smoothed);
                EXPECT_LE(seen, 1.002) << chord << " " << tolerance;
                const Jumps worst = jumps(program);
                EXPECT_LT(worst.place, 1e-11);
                EXPECT_LT(worst.turn, 1e-9);
                EXPECT_LT(worst.bend, 1e-4) << chord << " " << tolerance;
                if (chord < 0.1) {
                    EXPECT_LT(program.moves.size() * 5, before);
                }
            }
        }
    }
}

Program stadium(double feed) {
    ProgramBuilder builder;
    builder.line({50, 0, 0}, feed);
    builder.arc({50, 10, 0}, {0, 0, 1}, M_PI, 0, feed);
    builder.line({0, 20, 0}, feed);
    return with_tolerance(builder.program(), 0.005);
}

TEST(SmoothPath, OfALineAndATangentArcLeavesNoStepOfCurvature) {
    Program program = stadium(500);
    Smoothed smoothed;
    EXPECT_LE(smooth_and_search(program, smoothed), 1.002);
    EXPECT_EQ(smoothed.curves, 2);
    const Jumps worst = jumps(program);
    EXPECT_LT(worst.place, 1e-11);
    EXPECT_LT(worst.turn, 1e-9);
    EXPECT_LT(worst.bend, 1e-6);
}

TEST(SmoothPath, OfAFullCircleIsEnteredAndLeftSmoothly) {
    ProgramBuilder builder;
    builder.line({50, 0, 0}, 500);
    builder.arc({50, 10, 0}, {0, 0, 1}, 2 * M_PI, 0, 500);
    builder.line({100, 0, 0}, 500);
    builder.program().moves[1].end = builder.program().moves[1].start;
    Program program = with_tolerance(builder.program(), 0.005);
    Smoothed smoothed;
    EXPECT_LE(smooth_and_search(program, smoothed), 1.002);
    EXPECT_EQ(smoothed.curves, 2);
    EXPECT_LT(jumps(program).bend, 1e-6);
}

TEST(SmoothPath, IsAsProgrammedWhereTheFeedPassesJoints) {
    Program program = stadium(10);
    const Smoothed smoothed = ref::smooth_path(program, ref::Machine());
    EXPECT_EQ(program.moves.size(), 3);
    EXPECT_EQ(smoothed.deviation, 0);
}

TEST(SmoothPath, LeavesStopsAndAuxiliaryAxesWhereTheyAre) {
    ProgramBuilder builder;
    builder.line({10, 0, 0}, 100).exact_stop = true;
    builder.line({10, 10, 0}, 100);
    builder.line({20, 10, 0}, 100).aux_end[0] = 90;
    builder.line({20, 20, 0}, 0);  // a rapid
    builder.line({10, 20, 0}, 100);
    Program program = with_tolerance(builder.program(), 0.1);
    const Smoothed smoothed = ref::smooth_path(program, ref::Machine());
    EXPECT_EQ(smoothed.deviation, 0);
    EXPECT_EQ(program.moves.size(), 5);
}

/// Random lines, or lines and arcs: every kind of neighbour at every size.
class RandomPaths : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomPaths, testing::Range(0, 40),
                         [](const auto& seed) { return "seed_" + std::to_string(seed.param); });

TEST_P(RandomPaths, OfLinesKeepTheTolerance) {
    for (const double tolerance : {0.0005, 0.005, 0.05}) {
        Program program =
            with_tolerance(random_lines(static_cast<unsigned>(GetParam())), tolerance);
        Smoothed smoothed;
        EXPECT_LE(smooth_and_search(program, smoothed), 1.002) << tolerance;
        EXPECT_LT(jumps(program).place, 1e-9);
    }
}

TEST_P(RandomPaths, OfLinesAndArcsKeepTheTolerance) {
    for (const double tolerance : {0.001, 0.05}) {
        Program program =
            with_tolerance(random_program(static_cast<unsigned>(GetParam()), 40, 10), tolerance);
        for (std::size_t i = 1; i < program.moves.size(); ++i) {
            EXPECT_EQ(program.moves[i].start, program.moves[i - 1].end);
        }
        Smoothed smoothed;
        EXPECT_LE(smooth_and_search(program, smoothed), 1.002) << tolerance;
        EXPECT_LT(jumps(program).place, 1e-9);
    }
}

}  // namespace curvecore::tb::smooth_path_test
