// SPDX-License-Identifier: Apache-2.0
// Bounds of joints' stretches against the derivatives at their places.
#include "ref/limits/joint_shape.hpp"

#include <gtest/gtest.h>

#include "ref/limits/limits.hpp"
#include "ref/numeric/angles.hpp"
#include "tb/support/segments/joint_machines.hpp"

namespace curvecore::tb::joint_shape_test {

using ref::Move;
using ref::Vec3;

class JointShape : public testing::TestWithParam<std::string> {};

TEST_P(JointShape, BoundsEveryLoadOfItsStretch) {
    const ref::Machine machine = joint_machine(GetParam());
    const ref::PlanOptions options = series_options();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    double closest = 0;
    std::size_t count = 0;
    for (int n = 0; n < 20; ++n) {
        ref::Program program;
        program.moves = {tool_move(GetParam(), random)};
        ref::JointMoves moves(ref::source_of(program), "part.ngc", machine, options);
        for (Move piece; moves.next(piece);) {
            double end = 0;
            for (const ref::JointStretch& of : joint_stretches(piece, machine)) {
                EXPECT_EQ(of.from, end);
                end = of.to;
                ++count;
                const ref::PathShape& shape = of.shape;
                for (int i = 0; i <= 6; ++i) {
                    const double s = of.from + (of.to - of.from) * i / 6;
                    const double v = 100 * std::abs(any(random));
                    const double a = 1000 * any(random);
                    const double j = 1e4 * any(random);
                    const auto load = [&](const auto& series, int k) {
                        const Vec3 d1 = series.derivative(s, 1);
                        const Vec3 d2 = series.derivative(s, 2);
                        return k == 2 ? Vec3(d1 * a + d2 * v * v)
                                      : Vec3(d1 * j + 3 * d2 * v * a +
                                             series.derivative(s, 3) * v * v * v);
                    };
                    const Vec3 acceleration = load(piece.joints.joints, 2);
                    const Vec3 jerk = load(piece.joints.joints, 3);
                    const double across = v * v * shape.curvature;
                    const double cross =
                        3 * v * std::abs(a) * shape.curvature + v * v * v * shape.swerve;
                    for (int axis = 0; axis < 3; ++axis) {
                        const auto at = static_cast<std::size_t>(axis);
                        const double rate = piece.joints.joints.derivative(s, 1)[axis];
                        EXPECT_LE(std::abs(rate), shape.along[at] * (1 + 1e-12));
                        const double most = shape.swing[at] * std::hypot(a, across);
                        EXPECT_LE(std::abs(acceleration[axis]), most * (1 + 1e-12));
                        EXPECT_LE(std::abs(jerk[axis]),
                                  shape.swing[at] * std::hypot(j, cross) * (1 + 1e-12));
                        closest = std::max(closest, std::abs(acceleration[axis]) / most);
                    }
                    const auto& tool = piece.joints.tool;
                    const Vec3 bend = tool.derivative(s, 2);
                    const Vec3 along = tool.derivative(s, 1);
                    const Vec3 swerve =
                        tool.derivative(s, 3) + bend.squaredNorm() / along.squaredNorm() * along;
                    EXPECT_NEAR(along.norm(), shape.tool->rate, 1e-6);
                    EXPECT_LE(bend.norm(), shape.tool->curvature * (1 + 1e-9) + 1e-12);
                    EXPECT_LE(swerve.norm(), shape.tool->swerve * (1 + 1e-9) + 1e-9);
                }
            }
            EXPECT_DOUBLE_EQ(end, piece.joints.length);
        }
    }
    EXPECT_GT(closest, 0.6);
    EXPECT_GT(count, 20U);
}

TEST_P(JointShape, LosesLittleOfTheSpeedOfItsPlaces) {
    const ref::Machine machine = joint_machine(GetParam());
    std::mt19937_64 random(8);
    for (int n = 0; n < 20; ++n) {
        ref::Program program;
        program.moves = {tool_move(GetParam(), random)};
        program.moves[0].rapid = true;
        ref::JointMoves moves(ref::source_of(program), "part.ngc", machine, series_options());
        for (Move piece; moves.next(piece);) {
            for (const ref::JointStretch& of : joint_stretches(piece, machine)) {
                const double v = top_speed(of.shape, machine);
                EXPECT_LE(v, path_speed(of.shape, machine) * (1 + 1e-12));
                double best = 0;
                for (int i = 0; i < 5; ++i) {
                    const double s = of.from + (of.to - of.from) * i / 5;
                    Move place = piece;
                    place.joints = piece.joints.part(s, s + 1e-9);
                    for (std::size_t axis = 0; axis < ref::kAuxAxes; ++axis) {
                        const double travel = piece.aux_end[axis] - piece.aux_start[axis];
                        place.aux_end[axis] =
                            piece.aux_start[axis] + travel * 1e-9 / piece.joints.length;
                    }
                    best = std::max(best,
                                    top_speed(joint_stretches(place, machine)[0].shape, machine));
                }
                EXPECT_LE(v, best * (1 + 1e-9));
                if (of.to - of.from > 2e-3) EXPECT_GE(v, 0.999 * ref::kLeastShare * best);
            }
        }
    }
}

TEST(JointShapeOfACorner, StopsAtTheSameTurnOnAnyMachine) {
    for (const double degrees : {10.0, 20.0, 90.0}) {
        for (const char* name : {"delta", "polar"}) {
            const ref::Machine machine = joint_machine(name);
            const double turn = degrees * ref::kRadiansPerDegree;
            ref::Program program;
            program.moves.resize(2);
            program.moves[0].start = Vec3(30, 5, 0);
            program.moves[0].end = program.moves[1].start = Vec3(40, 5, 0);
            program.moves[1].end = Vec3(40 + 10 * std::cos(turn), 5 + 10 * std::sin(turn), 0);
            ref::JointMoves moves(ref::source_of(program), "part.ngc", machine, series_options());
            std::vector<ref::PathShape> shapes;
            double corner = -1;
            for (Move piece; moves.next(piece);) {
                for (const ref::JointStretch& of : joint_stretches(piece, machine)) {
                    if (!shapes.empty()) {
                        const double v = joint_velocity(shapes.back(), of.shape, machine);
                        if (corner < 0 || v < corner) corner = v;
                    }
                    shapes.push_back(of.shape);
                }
            }
            EXPECT_EQ(corner == 0, degrees > 15) << name << ' ' << degrees;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Machines, JointShape, testing::ValuesIn(joint_machine_names()),
                         [](const auto& of) { return of.param; });

}  // namespace curvecore::tb::joint_shape_test
