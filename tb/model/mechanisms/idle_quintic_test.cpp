// SPDX-License-Identifier: Apache-2.0
// The quintic of idle moves: smooth at its points, one quintic recovered, no oscillating curvature;
// jumps at control points, and jumps of rounding.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "ref/curve/fit/hermite.hpp"
#include "ref/join/jumps.hpp"
#include "ref/join/quintic_slopes.hpp"

namespace curvecore::ref::idle_quintic_test {

Joint at(const Vec3& position, const Vec3& tangent) {
    return {{position, tangent, Vec3::Zero()}, 25};
}

/// A move 5 mm aside over l: tangents of 1 and ends without curvature.
IdleMove lane_change(JoinFit fit, double l, int points) {
    return default_idle_move(at(Vec3(0, 0, 0), Vec3(1, 0, 0)), at(Vec3(l, 5, 0), Vec3(1, 0, 0)),
                             fit, points);
}

/// The nth derivative by t of a Bezier piece at its start or end.
Vec3 derivative(BezierPiece piece, int n, bool at_end) {
    for (; n > 0; --n) {
        BezierPiece slope{piece.h, {}};
        for (int i = 0; i < piece.degree(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            slope.points.emplace_back(piece.degree() / piece.h *
                                      (piece.points[k + 1] - piece.points[k]));
        }
        piece = slope;
    }
    return at_end ? piece.points.back() : piece.points.front();
}

int curvature_extrema(const std::vector<BezierPiece>& pieces) {
    const PathTable path(pieces);
    constexpr int kPlaces = 4000;
    constexpr double kFlat = 1e-9;
    int count = 0;
    double before = 0, last = path.at(0.).curvature.norm();
    for (int i = 1; i <= kPlaces; ++i) {
        const double here = path.at(path.length() * i / kPlaces).curvature.norm();
        const double rise = here - last;
        last = here;
        if (std::abs(rise) < kFlat) continue;
        count += before * rise < 0;
        before = rise;
    }
    return count;
}

TEST(IdleQuintic, FourDerivativesGoOnAtEveryPoint) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
    for (int n = 0; n < 200; ++n) {
        IdleMove move;
        move.start = {{vector(), vector().normalized(), vector()}, 20};
        move.end = {{10 * vector(), vector().normalized(), vector()}, 20};
        move.t = {0};
        for (int i = 0; i < 1 + n % 6; ++i) {
            move.points.push_back(5 * vector());
            move.t.push_back(move.t.back() + 2 + any(random));
        }
        move.t.push_back(move.t.back() + 2 + any(random));
        const std::vector<BezierPiece> pieces = move.pieces();
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            for (int order = 0; order <= 4; ++order) {
                const Vec3 jump =
                    derivative(pieces[i], order, false) - derivative(pieces[i - 1], order, true);
                ASSERT_LE(jump.norm(), 1e-9) << "derivative " << order << " of move " << n;
            }
        }
        EXPECT_LE((derivative(pieces.front(), 2, false) - move.start.curvature).norm(), 1e-10);
        EXPECT_LE((derivative(pieces.back(), 1, true) - move.end.tangent).norm(), 1e-10);
    }
}

TEST(IdleQuintic, OneQuinticIsFoundAgain) {
    const IdleMove whole = lane_change(JoinFit::kQuintic, 40, 0);
    const PathTable one(whole.pieces());
    for (const int points : {1, 3, 7}) {
        const IdleMove move = lane_change(JoinFit::kQuintic, 40, points);
        for (const BezierPiece& piece : move.pieces()) {
            EXPECT_NEAR(derivative(piece, 5, false).y(),
                        derivative(whole.pieces().front(), 5, false).y(), 1e-9);
        }
    }
}

// The curvature oscillates between the points for slopes by [Petrakov] (1), and for (1) of them.
TEST(IdleQuintic, CurvatureDoesNotSwing) {
    const IdleMove move = lane_change(JoinFit::kQuintic, 40, 3);
    EXPECT_EQ(curvature_extrema(move.pieces()), 3);
    const std::vector<Vec3> y = move.positions();
    Vectors m = bessel_slopes(y, move.t);
    m.front() = m.back() = Vec3::UnitX();
    Vectors second = bessel_slopes(m, move.t);
    second.front() = second.back() = Vec3::Zero();
    std::vector<BezierPiece> pieces;
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
        const double h = move.t[i + 1] - move.t[i];
        const auto points =
            quintic_points({h, y[i], y[i + 1], m[i], m[i + 1], second[i], second[i + 1]});
        pieces.push_back({h, {points.begin(), points.end()}});
    }
    EXPECT_EQ(curvature_extrema(pieces), 11);
}

TEST(IdleQuintic, JumpsAtControlPointsAreThoseOfTheFit) {
    for (const JoinFit fit : {JoinFit::kC2, JoinFit::kQuintic}) {
        const Jump jump = worst_inside(lane_change(fit, 40, 3), SpeedLaw::kSmooth);
        EXPECT_EQ(jump.curvature, 0);
        EXPECT_EQ(jump.slope, 0);
    }
    // A cubic through the middle (l/2, w/2): y'' goes from -4 w/l^2 to 4 w/l^2 at the slope w/l.
    IdleMove cubic = lane_change(JoinFit::kCubic, 10, 1);
    cubic.t = {0, 5, 10};
    cubic.points = {Vec3(5, 2.5, 0)};
    const double slope = 0.5;
    const Jump jump = worst_inside(cubic, SpeedLaw::kSmooth);
    EXPECT_NEAR(jump.curvature, 8 * 5. / 100 / std::pow(1 + slope * slope, 1.5), 1e-12);
    EXPECT_NEAR(jump.across, 25 * 25 * jump.curvature / kGravity, 1e-15);
    EXPECT_EQ(jump.slope, 0);
    cubic.fit = JoinFit::kMoments;
    cubic.points = {Vec3(4, 3, 0)};
    EXPECT_GT(worst_inside(cubic, SpeedLaw::kSmooth).slope, 0.01);
    EXPECT_EQ(worst_inside(lane_change(JoinFit::kCubic, 40, 0), SpeedLaw::kSmooth).curvature, 0);
}

TEST(IdleQuintic, JumpsOfRoundingAreZero) {
    IdleMove move = lane_change(JoinFit::kQuintic, 40, 3);
    move.start.tangent = Vec3(1, 2, 2) / 3;
    move.start.curvature = Vec3(0.02, -0.01, 0);
    const JoinJumps found = jumps(move, SpeedLaw::kSmooth);
    for (const Jump& jump : {found.start, found.end}) {
        EXPECT_EQ(jump.slope, 0);
        EXPECT_EQ(jump.curvature, 0);
        EXPECT_EQ(jump.across, 0);
    }
    move.start.curvature.z() += 2e-9;  // a jump, though a small one
    const Joint working{{Vec3::Zero(), move.start.tangent, Vec3(0.02, -0.01, 0)}, 25};
    EXPECT_GT(jump(working, PathTable(move.pieces()).at(0.), 0).curvature, 1e-9);
}

}  // namespace curvecore::ref::idle_quintic_test
