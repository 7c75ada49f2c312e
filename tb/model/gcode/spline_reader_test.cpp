// SPDX-License-Identifier: Apache-2.0
// Meaning of G5, G5.1, G5.2 and G5.3, against control points worked out by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ref/curve/arc_length.hpp"
#include "ref/program/gcode_reader.hpp"

namespace curvecore::tb::spline_reader_test {

using ref::Move;
using ref::Program;
using ref::Vec3;

Program read(const std::string& text) {
    return ref::read_gcode_text("G21 G90 G17 G94 F600\n" + text, "part.ngc");
}

void expect_bezier(const Move& move, const std::array<Vec3, 4>& points, double tolerance = 1e-13) {
    ASSERT_EQ(move.kind, Move::Kind::kCubic);
    const ref::Bezier found = ref::to_bezier(move.cubic);
    for (int i = 0; i < 4; ++i) {
        EXPECT_LE((found[i] - points[i]).norm(), tolerance)
            << i << ": " << found[i].transpose() << " is not " << points[i].transpose();
    }
    EXPECT_EQ(move.start, points[0]);
    EXPECT_EQ(move.end, points[3]);
}

TEST(SplineReader, CubicHasItsControlPointsAtIJFromItsStartAndPQFromItsEnd) {
    const Program program = read("G1 X1 Y2 Z3\nG5 X11 Y4 I3 J5 P-2 Q1.5");
    ASSERT_EQ(program.moves.size(), 2U);
    const Move& move = program.moves[1];
    expect_bezier(move, {Vec3(1, 2, 3), Vec3(4, 7, 3), Vec3(9, 5.5, 3), Vec3(11, 4, 3)});
    EXPECT_EQ(move.line, 3);
    EXPECT_EQ(move.feed, 10);
    EXPECT_FALSE(move.rapid);
    EXPECT_TRUE(move.exact_stop);
    EXPECT_EQ(move.length(), ref::arc_length(move.cubic, 0, 1));
}

TEST(SplineReader, CubicBehindACubicLeavesAlongItUnlessToldOtherwise) {
    const Program program = read(
        "G5 I0 J3 P0 Q-3 X1 Y1\nP0 Q-3 X2 Y2\nM8\nG4 P1\nG5 I1 J1 P1 Q1 X3 Y3\n"
        "G20 X1 Y1 P-1 Q0\nX2 P0 Q1");
    ASSERT_EQ(program.moves.size(), 5U);
    expect_bezier(program.moves[1], {Vec3(1, 1, 0), Vec3(1, 4, 0), Vec3(2, -1, 0), Vec3(2, 2, 0)});
    expect_bezier(program.moves[2], {Vec3(2, 2, 0), Vec3(3, 3, 0), Vec3(4, 4, 0), Vec3(3, 3, 0)});
    expect_bezier(program.moves[3],
                  {Vec3(3, 3, 0), Vec3(2, 2, 0), Vec3(0, 25.4, 0), Vec3(25.4, 25.4, 0)});
    expect_bezier(program.moves[4], {Vec3(25.4, 25.4, 0), Vec3(50.8, 25.4, 0), Vec3(50.8, 50.8, 0),
                                     Vec3(50.8, 25.4, 0)});
    EXPECT_EQ(program.moves[1].dwell, 1);
}

/// One K in each block of a NURBS, as in Fanuc's G06.2, and the rest after the last point.
TEST(SplineReader, NurbsWithKnotsOfItsOwn) {
    const auto with = [](const char* a, const char* b, const char* c) {
        return read(std::string("G5.2 L3 P1 K0\nX0 Y10 K0\nX10 Y10 K0\nX20 Y0 K") + a + "\nK" + b +
                    "\nK" + c + "\nK4\nG5.3");
    };
    // Knots 0 0 0 1 4 4 4: the joint is where the second leg is divided as 1 to 3.
    const Program program = with("1", "4", "4");
    ASSERT_EQ(program.moves.size(), 2U);
    EXPECT_LE((program.moves[0].end - Vec3(2.5, 10, 0)).norm(), 1e-13);
    EXPECT_LE((program.moves[0].cubic.velocity(1).normalized() - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_EQ(program.moves[1].end, Vec3(20, 0, 0));
    // Equal knots to LinuxCNC's give the same curve, bit for bit.
    const Program uniform = read("G5.2 L3\nX0 Y10\nX10 Y10\nX20 Y0\nG5.3");
    const Program given = read("G5.2 L3 K0\nX0 Y10 K0\nX10 Y10 K0\nX20 Y0 K1\nK2\nK2\nK2\nG5.3");
    ASSERT_EQ(given.moves.size(), uniform.moves.size());
    for (std::size_t i = 0; i < given.moves.size(); ++i) {
        EXPECT_EQ(given.moves[i].cubic.a, uniform.moves[i].cubic.a);
        EXPECT_EQ(given.moves[i].end, uniform.moves[i].end);
    }
}

TEST(SplineReader, ModesOfDistanceAndOffsetsMoveTheEndAndNotTheLegs) {
    const Program program =
        read("G10 L2 P1 X100\nG90.1 G91 G1 X1\nG5 X10 Y1 I1 J2 P3 Q4\nX-5 Y1 P0 Q1");
    expect_bezier(program.moves[1], {Vec3(1, 0, 0), Vec3(2, 2, 0), Vec3(14, 5, 0), Vec3(11, 1, 0)});
    expect_bezier(program.moves[2], {Vec3(11, 1, 0), Vec3(8, -3, 0), Vec3(6, 3, 0), Vec3(6, 2, 0)});
}

TEST(SplineReader, QuadraticIsTheParabolaOfItsThreePoints) {
    const Program program = read("G1 X-2 Y4\nG5.1 X2 I2 J-8");
    const Move& move = program.moves[1];
    for (const double u : {0.0, 0.2, 0.5, 1.0}) {
        const Vec3 point = move.cubic.position(u);
        EXPECT_NEAR(point.x(), -2 + 4 * u, 1e-15);
        EXPECT_NEAR(point.y(), point.x() * point.x(), 2e-15);
    }
    expect_bezier(read("G5.1 X6 Y3 J3").moves[0],
                  {Vec3(0, 0, 0), Vec3(0, 2, 0), Vec3(2, 3, 0), Vec3(6, 3, 0)});
}

TEST(SplineReader, ClosedCubicMayEndWhereItBegins) {
    const Program program = read("G1 X5\nG5 X5 Y0 I10 J0 P0 Q10");
    EXPECT_EQ(program.moves[1].start, program.moves[1].end);
    EXPECT_GT(program.moves[1].length(), 5);
}

TEST(SplineReader, ZeroLegsAreStopsAndNoError) {
    const Program program = read("G5 X10 Y0 I0 J0 P0 Q0\nX20 Y0 P0 Q5");
    EXPECT_NEAR(program.moves[0].length(), 10, 1e-12);
    EXPECT_TRUE(ref::has_cusp(program.moves[0].cubic));
}

TEST(SplineReader, NurbsOfOrderFourIsExactPieceByPiece) {
    // Six points, uniform clamped knots 0 0 0 0 1 2 3 3 3 3: Bernstein points by hand.
    const Program program =
        read("G61.1\nG5.2 L4 X0 Y6\nX6 Y6\nX6 Y0 F1200\nX12 Y0\nX12 Y6\nG5.3\nG1 X0");
    ASSERT_EQ(program.moves.size(), 4U);
    expect_bezier(program.moves[0], {Vec3(0, 0, 0), Vec3(0, 6, 0), Vec3(3, 6, 0), Vec3(4.5, 5, 0)});
    expect_bezier(program.moves[1],
                  {Vec3(4.5, 5, 0), Vec3(6, 4, 0), Vec3(6, 2, 0), Vec3(7.5, 1, 0)});
    expect_bezier(program.moves[2],
                  {Vec3(7.5, 1, 0), Vec3(9, 0, 0), Vec3(12, 0, 0), Vec3(12, 6, 0)});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(program.moves[i].line, 8) << "the line of G5.3";
        EXPECT_EQ(program.moves[i].feed, 20);
        EXPECT_EQ(program.moves[i].exact_stop, i == 2) << "a stop at the end of the curve alone";
    }
    EXPECT_EQ(program.moves[3].start, Vec3(12, 6, 0));
}

TEST(SplineReader, NurbsTakesOrderThreeAndWeightsOneWhereNothingIsSaid) {
    const Program short_form = read("G5.2 X5 Y5\nX10 Y0\nX15 Y5\nG5.3");
    const Program long_form = read("G5.2 P1 L3\nX5 Y5 P1\nG5.2 X10 Y0 P1 L3\nX15 Y5 P1\nG5.3");
    ASSERT_EQ(short_form.moves.size(), 2U);
    ASSERT_EQ(long_form.moves.size(), 2U);
    for (int i = 0; i < 2; ++i) {
        expect_bezier(long_form.moves[i], ref::to_bezier(short_form.moves[i].cubic));
    }
    EXPECT_EQ(short_form.moves[0].end, Vec3(7.5, 2.5, 0));
}

TEST(SplineReader, NurbsPointsCountFromItsStartWithG91) {
    const Program program = read("G1 X10 Y10\nG91 G5.2 X5 Y5\nX10 Y0\nG5.3\nG1 X1");
    EXPECT_EQ(program.moves[1].start, Vec3(10, 10, 0));
    EXPECT_EQ(program.moves[1].end, Vec3(20, 10, 0));
    EXPECT_EQ(program.moves[2].end, Vec3(21, 10, 0));
}

TEST(SplineReader, WeightsDrawACircleWithinTheTolerance) {
    const Program program = read(
        "G1 X10\nG5.2 X10 Y10 P0.707106781186547524\nX0 Y10\nG5.3\n"
        "G5.2 X-10 Y10 P0.707106781186547524\nX-10 Y0\nG5.3\n"
        "G5.2 P0.707106781186547524 L3\nX-10 Y-10 P.5\nX0 Y-10 P.707106781186547524\nG5.3\n"
        "G5.2 X10 Y-10 P0.707106781186547524\nX10 Y0\nG5.3");
    double length = 0;
    double worst = 0;
    for (std::size_t i = 1; i < program.moves.size(); ++i) {
        const Move& move = program.moves[i];
        length += move.length();
        for (double u = 0; u <= 1; u += 0.0625) {
            worst = std::max(worst, std::abs(move.cubic.position(u).norm() - 10));
        }
    }
    EXPECT_LE(worst, ref::kFitTolerance);
    EXPECT_GE(worst, ref::kFitTolerance / 100);
    EXPECT_NEAR(length, 20 * 3.14159265358979, 1e-7);
    EXPECT_EQ(program.moves.size(), 1 + 4 * 8U);
}

TEST(SplineReader, ToleranceIsTheCallers) {
    const std::string text = "G21 F600\nG5.2 X5 Y5 P0.2\nX10 Y0\nG5.3";
    const auto moves_within = [&](double tolerance) {
        ref::GcodeOptions options;
        options.fit_tolerance = tolerance;
        return ref::read_gcode_text(text, "part.ngc", options).moves.size();
    };
    EXPECT_LT(3 * moves_within(1e-3), moves_within(1e-9));
}

TEST(SplineReader, InverseTimeIsThatOfTheWholeCurve) {
    const auto minutes = [](const Program& program) {
        double sum = 0;
        for (const Move& move : program.moves) sum += move.length() / move.feed / 60;
        return sum;
    };
    EXPECT_NEAR(minutes(read("G93 G5 X10 Y0 I3 J3 P-3 Q3 F2")), 0.5, 1e-15);
    const Program early = read("G93 G5.2 F4 P2\nX5 Y5\nX10 Y0\nX15 Y5\nG5.3");
    EXPECT_GT(early.moves.size(), 2U);
    EXPECT_NEAR(minutes(early), 0.25, 1e-14);
    EXPECT_NEAR(minutes(read("G93 G5.2 L3\nX5 Y5 F4\nX10 Y0 P3\nX15 Y5\nG5.3 F8")), 0.125, 1e-14);
}

TEST(SplineReader, PiecesWithoutLengthAreLeftOutAndCounted) {
    const Program program = read("G5.2 L2 X5 Y5\nX5 Y5\nX10 Y0\nG5.3");
    ASSERT_EQ(program.moves.size(), 2U);
    EXPECT_EQ(program.moves[1].start, Vec3(5, 5, 0));
    EXPECT_EQ(program.warnings.front(),
              "part.ngc:5: warning: a piece of a spline without length is left out");
}

TEST(SplineReader, SplinesMixWithLinesAndArcs) {
    const Program program = read(
        "G1 X10\nG5 X20 Y10 I5 J0 P0 Q-5\nG3 X10 Y20 I-10\nG5.2 X0 Y20 L4\nX-10 Y15\nX-10 "
        "Y0\nG5.3\nG1 X0 Y0");
    const std::vector<Move::Kind> kinds{Move::Kind::kLine, Move::Kind::kCubic, Move::Kind::kArc,
                                        Move::Kind::kCubic, Move::Kind::kLine};
    ASSERT_EQ(program.moves.size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(program.moves[i].kind, kinds[i]);
        if (i > 0) {
            EXPECT_EQ(program.moves[i].start, program.moves[i - 1].end);
        }
    }
}

}  // namespace curvecore::tb::spline_reader_test
