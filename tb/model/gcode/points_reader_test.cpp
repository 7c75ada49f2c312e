// SPDX-License-Identifier: Apache-2.0
// Files of points: columns, comments, and the moves that a fit makes of them.
#include "ref/program/points_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ref/program/program_reader.hpp"

namespace curvecore::tb::points_reader_test {

using ref::Fit;
using ref::Move;
using ref::Program;
using ref::Vec3;

Program read(const std::string& text, Fit fit = Fit::kBessel) {
    ref::PointsOptions options;
    options.fit = fit;
    return ref::read_points_text(text, "points.csv", options);
}

TEST(PointsReader, MovesLeadFromPointToPoint) {
    const Program program = read("0,0,0\n10,5,1\n20,0,-2.5e0\n");
    ASSERT_EQ(program.moves.size(), 2U);
    EXPECT_EQ(program.moves[0].start, Vec3(0, 0, 0));
    EXPECT_EQ(program.moves[0].end, Vec3(10, 5, 1));
    EXPECT_EQ(program.moves[1].start, Vec3(10, 5, 1));
    EXPECT_EQ(program.moves[1].end, Vec3(20, 0, -2.5));
    EXPECT_EQ(program.file, "points.csv");
    EXPECT_EQ(program.aux_axes, 0);
    for (const Move& move : program.moves) {
        EXPECT_EQ(move.kind, Move::Kind::kCubic);
        EXPECT_DOUBLE_EQ(move.feed, 1000.0 / 60);
        EXPECT_FALSE(move.rapid);
        EXPECT_LE((move.cubic.position(0) - move.start).norm(), 1e-14);
        EXPECT_LE((move.cubic.position(1) - move.end).norm(), 1e-14);
    }
    EXPECT_FALSE(program.moves[0].exact_stop);
    EXPECT_TRUE(program.moves[1].exact_stop);
    EXPECT_EQ(program.moves[1].line, 3);
}

TEST(PointsReader, NumbersStandBetweenCommasSemicolonsBlanksOrTabs) {
    for (const char* text :
         {"0,0,0\n10,5,1\n20,0,-2\n", "0;0;0\n10 ; 5;1\n20;0;-2\n",
          "0 0 0\n 10  5\t1 # one\n20\t0\t-2\n", "x y z\n0 0 0\n10 5 1\n20 0 -2\n"}) {
        const Program program = read(text);
        ASSERT_EQ(program.moves.size(), 2U) << text;
        EXPECT_EQ(program.moves[0].end, Vec3(10, 5, 1)) << text;
        EXPECT_EQ(program.moves[1].end, Vec3(20, 0, -2)) << text;
    }
}

TEST(PointsReader, WithoutAColumnZItIsZero) {
    EXPECT_EQ(read("0,0\n10,4\n20,3\n").moves[0].end, Vec3(10, 4, 0));
    EXPECT_EQ(read("y;x\n0;0\n10;4\n20;3\n").moves[0].end, Vec3(4, 10, 0));
    EXPECT_EQ(read("x,y,a\n0,0,0\n10,4,90\n").moves[0].aux_end[0], 90);
}

TEST(PointsReader, HeaderNamesColumnsInAnyOrderAndCase) {
    const Program program = read(
        "\xEF\xBB\xBF# a curve\r\n\r\n  Z , y,X, C # turned\r\n1,2,3,+45\r\n\t4 ,5, 6,90\r\n"
        "#end\r\n7,8,10,0");
    EXPECT_EQ(program.moves[0].start, Vec3(3, 2, 1));
    EXPECT_EQ(program.moves[0].end, Vec3(6, 5, 4));
    EXPECT_EQ(program.moves[0].aux_start[2], 45);
    EXPECT_EQ(program.moves[0].aux_end[2], 90);
    EXPECT_EQ(program.moves[1].aux_end[2], 0);
    EXPECT_EQ(program.moves[1].line, 7);
    EXPECT_EQ(program.aux_axes, 3);
}

TEST(PointsReader, FitAndParameterChangeTheCurveAndNotThePoints) {
    const std::string text = "0,0,0\n10,5,1\n20,0,-2\n21,1,0\n40,0,0\n";
    const Program bessel = read(text);
    ref::PointsOptions options;
    options.feed = 7;
    for (const Fit fit : {Fit::kAkima, Fit::kNatural}) {
        options.fit = fit;
        const Program other = ref::read_points_text(text, "points.csv", options);
        EXPECT_GT((other.moves[2].cubic.c - bessel.moves[2].cubic.c).norm(), 0.05);
        EXPECT_EQ(other.moves[2].start, bessel.moves[2].start);
        EXPECT_EQ(other.moves[2].feed, 7);
    }
    options.fit = Fit::kBessel;
    for (const ref::Parametrisation parametrisation :
         {ref::Parametrisation::kCentripetal, ref::Parametrisation::kUniform}) {
        options.parametrisation = parametrisation;
        const Program other = ref::read_points_text(text, "points.csv", options);
        EXPECT_GT((other.moves[2].cubic.c - bessel.moves[2].cubic.c).norm(), 0.05);
    }
}

TEST(PointsReader, TangentsOfTheFileAreThoseOfTheCurve) {
    const Program program =
        read("x,y,z,dx,dy,dz\n0,0,0,1,0,0\n3,4,0,0,2,0\n3,4,12,0,0,0\n", Fit::kHermite);
    EXPECT_LE((program.moves[0].cubic.velocity(0) - 5 * Vec3(1, 0, 0)).norm(), 1e-14);
    EXPECT_LE((program.moves[0].cubic.velocity(1) - 5 * Vec3(0, 2, 0)).norm(), 1e-14);
    EXPECT_LE((program.moves[1].cubic.velocity(0) - 12 * Vec3(0, 2, 0)).norm(), 1e-13);
    EXPECT_TRUE(ref::has_cusp(program.moves[1].cubic)) << "a zero tangent is a stop";
    const Program clamped =
        read("x,y,z,dx,dy,dz\n0,0,0,1,0,0\n3,4,0,,,\n3,4,12,0,1,0\n", Fit::kClamped);
    EXPECT_LE((clamped.moves[0].cubic.velocity(0) - 5 * Vec3(1, 0, 0)).norm(), 1e-14);
    EXPECT_LE((clamped.moves[1].cubic.velocity(1) - 12 * Vec3(0, 1, 0)).norm(), 1e-13);
}

TEST(PointsReader, SecondDerivativesOfTheFileAreThoseOfTheCurve) {
    const Program program =
        read("x,y,z,ddx,ddy,ddz\n0,0,0,0,0,0.5\n3,4,0,0,0.1,0\n", Fit::kMoments);
    EXPECT_LE((program.moves[0].cubic.acceleration(0) / 25 - Vec3(0, 0, 0.5)).norm(), 1e-14);
    EXPECT_LE((program.moves[0].cubic.acceleration(1) / 25 - Vec3(0, 0.1, 0)).norm(), 1e-14);
}

TEST(PointsReader, CornersOfSecondDerivativesAreSaid) {
    const std::string bent = "0,0,0\n10,5,0\n20,0,0\n30,6,0\n";
    const Program corners = read(bent, Fit::kMoments);
    ASSERT_EQ(corners.warnings.size(), 1U);
    const Vec3 in = corners.moves[1].cubic.velocity(1);
    const Vec3 out = corners.moves[2].cubic.velocity(0);
    const double degrees = std::acos(in.normalized().dot(out.normalized())) * 180 / M_PI;
    EXPECT_EQ(corners.warnings[0],
              fmt::format("points.csv:3: warning: a corner of {:.3g} degrees, the sharpest of 2: "
                          "these second derivatives are not those of a C2 spline (--fit c2 is one)",
                          degrees));
    EXPECT_GT(degrees, 1);
    EXPECT_TRUE(read("0,0,0\n10,5,0\n20,10,0\n", Fit::kMoments).warnings.empty()) << "straight";
    EXPECT_TRUE(read(bent, Fit::kC2).warnings.empty());
}

TEST(PointsReader, ClosedSplineEndsWhereItBegan) {
    ref::PointsOptions options;
    options.fit = Fit::kC2;
    options.ends = ref::Ends::kClosed;
    const Program program =
        ref::read_points_text("0,0,0\n10,0,1\n10,10,0\n0,0,0\n", "points.csv", options);
    const auto& moves = program.moves;
    EXPECT_LE(
        (moves.back().cubic.velocity(1).normalized() - moves.front().cubic.velocity(0).normalized())
            .norm(),
        1e-12);
}

TEST(PointsReader, AuxiliaryAxesOfAQuinticGoWithItsPathLength) {
    const Program program =
        read("x,y,z,dx,dy,dz,ddx,ddy,ddz,A\n0,0,0,1,0,0,0,.1,0,10\n10,5,3,0,1,0,0,0,0,50\n",
             Fit::kQuintic);
    ASSERT_GT(program.moves.size(), 2U);
    double length = 0;
    for (const Move& move : program.moves) length += move.length();
    double reached = 0;
    ref::Aux aux{10};
    for (const Move& move : program.moves) {
        reached += move.length();
        EXPECT_EQ(move.aux_start, aux);
        EXPECT_NEAR(move.aux_end[0], 10 + 40 * reached / length, 1e-12);
        aux = move.aux_end;
    }
    EXPECT_EQ(aux[0], 50);
    EXPECT_EQ(program.aux_axes, 1);
    EXPECT_EQ(program.moves.back().end, Vec3(10, 5, 3));
}

TEST(PointsReader, FilesOfTheExamplesAreRead) {
    const std::string folder = std::string(DATA_DIR) + "/";
    ref::PointsOptions options;
    for (const Fit fit : {Fit::kBessel, Fit::kAkima, Fit::kNatural}) {
        options.fit = fit;
        EXPECT_GE(ref::read_program(folder + "points.csv", options).moves.size(), 8U);
    }
    EXPECT_EQ(ref::read_program(folder + "points.csv", options).aux_axes, 1);
    EXPECT_GE(ref::read_program(folder + "demo.ngc", options).moves.size(), 8U);
}

}  // namespace curvecore::tb::points_reader_test
