// SPDX-License-Identifier: Apache-2.0
// Idle moves: closed forms of U-turns and lane changes, [Petrakov]'s 0.04 g in both readings, ends
// of working paths, control points by least squares.
#include "ref/join/idle_move.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/join/least.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/idle_turns.hpp"

namespace curvecore::ref::idle_move_test {

using tb::lane_change;
using tb::peak_curvature;
using tb::u_turn;

constexpr double kSlow = tb::kSlowFeed;

TEST(IdleMove, CubicUTurnJumpsBySixWOverKSquared) {
    for (const auto& [w, k] : {std::pair{1.0, 3.09}, {2.0, 4.37}, {5.0, 6.91}, {10.0, 9.78}}) {
        for (const JoinFit fit : {JoinFit::kCubic, JoinFit::kC2}) {
            const JoinJumps found = jumps(u_turn(fit, w, k), SpeedLaw::kSmooth);
            EXPECT_NEAR(found.start.curvature, 6 * w / (k * k), 1e-12);
            EXPECT_NEAR(found.end.curvature, 6 * w / (k * k), 1e-12);
            EXPECT_NEAR(found.start.across, 0.04, 1e-4) << "[Petrakov] at 1.5 m/min, w = " << w;
            EXPECT_LE(found.start.slope, 1e-15);
        }
    }
}

TEST(IdleMove, JumpGrowsWithTheSquareOfTheFeed) {
    IdleMove move = u_turn(JoinFit::kCubic, 5, 6.91);
    for (const auto& [feed, g] : {std::pair{100.0, 0.64}, {1000.0, 64.0}}) {
        move.start.feed = move.end.feed = feed;
        EXPECT_NEAR(jumps(move, SpeedLaw::kSmooth).end.across, g, 0.002 * g);
    }
}

/// The other reading: the speed of 25 mm/s is reached in 64 ms at a constant acceleration.
TEST(IdleMove, PetrakovsJumpAlongThePathIsASpeedReachedIn64Milliseconds) {
    IdleMove move = lane_change(JoinFit::kQuintic, 0, 0.8, 0);  // 25^2 / (2 0.04 g) = 0.797 mm
    move.start.feed = 1e-9;
    const JoinJumps even = jumps(move, SpeedLaw::kEven);
    EXPECT_NEAR(even.start.along, 0.04, 2e-4);
    EXPECT_NEAR(even.end.along, 0.04, 2e-4);
    EXPECT_NEAR(kSlow / (even.end.along * kGravity), 0.064, 2e-4);
    EXPECT_EQ(jumps(move, SpeedLaw::kSmooth).end.along, 0);
}

TEST(IdleMove, QuinticHasNoJumpAndTheKnownPeaks) {
    for (const auto& [w, k, g] :
         {std::tuple{2.0, 4.37, 0.0723}, {5.0, 6.91, 0.0450}, {10.0, 9.78, 0.0354}}) {
        const IdleMove quintic = u_turn(JoinFit::kQuintic, w, k);
        EXPECT_LE(jumps(quintic, SpeedLaw::kSmooth).start.across, 1e-15);
        EXPECT_NEAR(peak_curvature(quintic) * kSlow * kSlow / kGravity, g, 1e-4) << w;
    }
    const double w = 5, l = 6.91;
    const IdleMove lane = lane_change(JoinFit::kQuintic, w, l, 0);
    double second = 0;
    for (int i = 0; i <= 10000; ++i) {
        second = std::max(second, lane.pieces().front().at(i / 10000.0).d2.y());
    }
    EXPECT_NEAR(second, 10 / std::sqrt(3) * w / (l * l), 1e-6);
    EXPECT_NEAR(lane_change(JoinFit::kCubic, w, l, 0).pieces().front().at(0).d2.y(),
                6 * w / (l * l), 1e-12);
}

TEST(IdleMove, TwoOrdinatesOfACubicSplineMeetSlopeAndCurvature) {
    const IdleMove found = with_least(lane_change(JoinFit::kC2, 5, 6.91, 3), Least::kCurvature);
    EXPECT_NEAR(found.points[0].y(), 5.0 / 12, 1e-9);
    EXPECT_NEAR(found.points[1].y(), 2.5, 1e-9) << "the free one, by symmetry";
    EXPECT_NEAR(found.points[2].y(), 55.0 / 12, 1e-9);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.points[i].x(), found.t[i + 1], 1e-9);
    const JoinJumps met = jumps(found, SpeedLaw::kSmooth);
    EXPECT_LE(met.start.curvature + met.end.curvature, 1e-9);
    double second = 0;
    for (const BezierPiece& piece : found.pieces()) {
        second = std::max({second, piece.at(0).d2.y(), piece.at(1).d2.y()});
    }
    EXPECT_NEAR(second, 0.838, 0.001) << "0.628 without: smoothness costs a higher peak";
    const IdleMove straight = lane_change(JoinFit::kC2, 5, 6.91, 3);
    EXPECT_GE(jumps(straight, SpeedLaw::kSmooth).start.curvature, 0.1) << "points as they were";
}

Vec3 random_vector() { return Vec3::Random(); }

/// A move whose ends have curvature, in space.
IdleMove twisted(JoinFit fit, int points) {
    IdleMove move;
    move.start = {{Vec3(1, 2, 3), Vec3(1, 2, 2) / 3, Vec3(0.02, -0.01, 0)}, 30};
    move.end = {{Vec3(20, -5, 8), Vec3(2, 2, -1) / 3, Vec3(0.01, 0, 0.02)}, 60};
    return default_idle_move(move.start, move.end, fit, points);
}

double bend(const IdleMove& move, Least least) {
    double sum = 0;
    for (const BezierPiece& piece : move.pieces()) {
        constexpr int kSteps = 400;
        const double h = piece.h / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const Vec3 d2 = piece.at((i + 0.5) / kSteps).d2;
            const Vec3 d3 = (piece.at((i + 1.0) / kSteps).d2 - piece.at(1.0 * i / kSteps).d2) / h;
            sum += (least == Least::kCurvature ? d2 : d3).squaredNorm() * h;
        }
    }
    return sum;
}

TEST(IdleMove, LeastPointsAreLeastAmongThoseThatMeetTheJoints) {
    std::srand(7);
    for (const JoinFit fit : {JoinFit::kCubic, JoinFit::kC2, JoinFit::kQuintic}) {
        for (const Least least : {Least::kCurvature, Least::kJerk}) {
            const IdleMove start = twisted(fit, 5);
            const IdleMove best = with_least(start, least);
            const JoinJumps met = jumps(best, SpeedLaw::kSmooth);
            EXPECT_LE(met.start.slope + met.end.slope, 1e-9);
            EXPECT_LE(met.start.curvature + met.end.curvature, 1e-9);
            const double reached = bend(best, least);
            // Any other points lead to the same ones, and moving on from them costs.
            IdleMove other = start;
            for (Vec3& point : other.points) point += 2 * random_vector();
            const IdleMove again = with_least(other, least);
            for (std::size_t i = 0; i < 5; ++i) {
                EXPECT_LE((again.points[i] - best.points[i]).norm(), 1e-8);
            }
            const IdleMove of_other =
                with_least(best, least == Least::kJerk ? Least::kCurvature : Least::kJerk);
            EXPECT_GT(bend(of_other, least), reached * (1 + 1e-6));
        }
    }
}

TEST(IdleMove, TooFewPointsForCurvatureAreSaid) {
    EXPECT_THROW(with_least(twisted(JoinFit::kC2, 1), Least::kJerk), std::invalid_argument);
    EXPECT_THROW(with_least(twisted(JoinFit::kCubic, 0), Least::kJerk), std::invalid_argument);
    EXPECT_NO_THROW(with_least(twisted(JoinFit::kC2, 2), Least::kJerk));
    EXPECT_NO_THROW(with_least(twisted(JoinFit::kQuintic, 0), Least::kJerk));
}

TEST(IdleMove, DefaultIsItsOwnLengthAndStraightWhereItCanBe) {
    const IdleMove line =
        default_idle_move({{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3::Zero()}, 1},
                          {{Vec3(1, 8, 0), Vec3(0, 1, 0), Vec3::Zero()}, 1}, JoinFit::kQuintic, 3);
    EXPECT_NEAR(line.t.back(), 8, 1e-9);
    EXPECT_LE((line.points[1] - Vec3(1, 4, 0)).norm(), 1e-9);
    IdleMove guide = u_turn(JoinFit::kQuintic, 5, 0);
    const IdleMove turn = default_idle_move(guide.start, guide.end, JoinFit::kQuintic, 0);
    EXPECT_NEAR(PathTable(turn.pieces()).length(), turn.t.back(), 1e-6);
    // Worst case: both tangents against the way.
    guide.start.tangent = guide.end.tangent = Vec3(-1, 0, 0);
    guide.end.position = Vec3(5, 0, 0);
    const IdleMove back = default_idle_move(guide.start, guide.end, JoinFit::kQuintic, 0);
    EXPECT_NEAR(PathTable(back.pieces()).length(), back.t.back(), 1e-6);
}

TEST(IdleMove, FitsKeepWhatTheyPromiseAtEveryJoint) {
    for (const JoinFit fit :
         {JoinFit::kCubic, JoinFit::kMoments, JoinFit::kC2, JoinFit::kQuintic}) {
        IdleMove move = twisted(fit, 3);
        move.points[1] += Vec3(1, 2, -3);
        const auto pieces = move.pieces();
        double d1 = 0;
        double d2 = 0;
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            const auto in = pieces[i - 1].at(1);
            const auto out = pieces[i].at(0);
            EXPECT_LE((in.r - out.r).norm(), 1e-13);
            d1 = std::max(d1, (in.d1 - out.d1).norm());
            d2 = std::max(d2, (in.d2 - out.d2).norm());
        }
        const JoinJumps ends = jumps(move, SpeedLaw::kSmooth);
        EXPECT_EQ(d1 > 1e-9, fit == JoinFit::kMoments) << d1;
        EXPECT_EQ(d2 > 1e-9, fit == JoinFit::kCubic) << d2;
        EXPECT_EQ(ends.start.slope > 1e-9, fit == JoinFit::kMoments);
        EXPECT_EQ(ends.start.curvature > 1e-9, fit != JoinFit::kQuintic) << ends.start.curvature;
    }
}

TEST(IdleMove, LineAndArcAreThereForComparison) {
    const auto rows = compare_joins(u_turn(JoinFit::kCubic, 5, 6.91), SpeedLaw::kSmooth);
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(rows[0].name, "line");
    EXPECT_NEAR(rows[0].start.slope, M_PI / 2, 1e-15);
    EXPECT_EQ(rows[1].name, "arc");
    EXPECT_NEAR(rows[1].length, 2.5 * M_PI, 1e-12);
    EXPECT_LE(rows[1].start.slope + rows[1].end.slope, 1e-12);
    EXPECT_NEAR(rows[1].start.curvature, 1 / 2.5, 1e-15);
    EXPECT_NEAR(rows[1].end.across, kSlow * kSlow / 2.5 / kGravity, 1e-15);
    IdleMove skew = twisted(JoinFit::kCubic, 0);
    skew.end.tangent = Vec3(1, 0, 0);
    EXPECT_GT(compare_joins(skew, SpeedLaw::kSmooth)[1].end.slope, 0.1);
}

TEST(Joint, EndsOfEveryKindOfMove) {
    const auto joint = [](const std::string& line, bool at_end) {
        const Program program = read_gcode_text("G17 F60\nG1 X10\n" + line + "\n", "part.ngc");
        return joint_of("part.ngc", program.moves.back(), at_end);
    };
    const Joint line = joint("G1 X10 Y5 F600", true);
    EXPECT_EQ(line.tangent, Vec3(0, 1, 0));
    EXPECT_EQ(line.feed, 10);
    const Joint arc = joint("G3 X0 Y10 I-10 J0", true);  // about 0, a quarter turn
    EXPECT_LE((arc.tangent - Vec3(-1, 0, 0)).norm(), 1e-14);
    EXPECT_LE((arc.curvature - Vec3(0, -0.1, 0)).norm(), 1e-14);
    const Joint clockwise = joint("G2 X0 Y10 I0 J10", false);
    EXPECT_LE((clockwise.tangent - Vec3(-1, 0, 0)).norm(), 1e-14);
    EXPECT_LE((clockwise.curvature - Vec3(0, 0.1, 0)).norm(), 1e-14);
    const Joint helix = joint("G3 X10 Y0 I-10 J0 Z5", true);
    const double pitch = std::hypot(20 * M_PI, 5);
    EXPECT_LE((helix.tangent - Vec3(0, 20 * M_PI, 5) / pitch).norm(), 1e-14);
    EXPECT_NEAR(helix.curvature.x(), -0.1 * std::pow(20 * M_PI / pitch, 2), 1e-14);
    const Joint spline = joint("G5 X20 Y5 I3 J0 P0 Q-4", true);
    EXPECT_LE((spline.tangent - Vec3(0, 1, 0)).norm(), 1e-14);
    // Of a Bezier curve: (2/3) |leg x (point - previous)| / |leg|^3
    EXPECT_NEAR(spline.curvature.norm(), 2.0 / 3 * 7 / 16, 1e-12);
    EXPECT_THROW(joint("G5 X20 Y5 I3 J0 P0 Q0", true), InputError);
}

TEST(Joint, PointsAlongAMoveMatchItsEnds) {
    const Program program =
        read_gcode_text("F60\nG3 X10 Y0 I5 J3 Z4 P2\nG5 X20 Y5 I3 J0 P0 Q-4\nG1 Z9\n", "p.ngc");
    for (const Move& move : program.moves) {
        const MovePlace first = place_on(move, 0);
        const MovePlace last = place_on(move, move.length());
        EXPECT_LE((first.position - move.start).norm(), 1e-9);
        EXPECT_LE((last.position - move.end).norm(), 1e-9);
        EXPECT_LE((last.tangent - joint_of("p.ngc", move, true).tangent).norm(), 1e-9);
    }
}

}  // namespace curvecore::ref::idle_move_test
