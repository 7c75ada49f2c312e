// SPDX-License-Identifier: Apache-2.0
// Cubics as tangent arcs and as chords, compared with points of the cubic.
#include "ref/curve/fit/arc_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "ref/moves/spline_form.hpp"
#include "tb/support/judge/curve_distance.hpp"

namespace curvecore::tb::arc_fit_test {

using ref::ArcFit;
using ref::Cubic;
using ref::Move;
using ref::RationalBezier;
using ref::TangentArc;
using ref::Vec3;

RationalBezier curve_of(const Cubic& cubic) {
    RationalBezier curve;
    curve.origin = cubic.position(0);
    for (const Vec3& point : ref::to_bezier(cubic)) {
        curve.points.emplace_back();
        curve.points.back() << point - curve.origin, 1;
    }
    return curve;
}

Vec3 end_tangent(const TangentArc& arc) {
    if (arc.angle == 0) return arc.tangent;
    return arc.tangent * std::cos(arc.angle) + arc.inward * std::sin(arc.angle);
}

Cubic random_cubic(std::mt19937& random, bool plane) {
    std::uniform_real_distribution<double> place(-10, 10);
    ref::Bezier points;
    for (Vec3& point : points) {
        point = {place(random), place(random), plane ? 3 : place(random)};
    }
    return ref::from_bezier(points);
}

TEST(Biarc, OfAnArcIsTheArc) {
    const Vec3 out = Vec3(1, 2, 2) / 3;
    const Vec3 n = Vec3(2, 1, -2) / 3;
    const Vec3 start(5, -3, 20);
    const double angle = 1.2;
    const Vec3 end = start + 7 * (out * std::sin(angle) + n * (1 - std::cos(angle)));
    const Vec3 in = out * std::cos(angle) + n * std::sin(angle);
    const auto arcs = ref::biarc(start, out, end, in);
    ASSERT_TRUE(arcs);
    for (const TangentArc& arc : *arcs) {
        EXPECT_NEAR(arc.radius, 7, 1e-12);
        EXPECT_NEAR(arc.angle, angle / 2, 1e-13);
        EXPECT_LE((arc.at(arc.length()) - arc.end).norm(), 1e-14);
    }
    EXPECT_LE((end_tangent((*arcs)[1]) - in).norm(), 1e-13);
}

TEST(Biarc, IsNotMadeOfMoreThanAQuarterTurn) {
    EXPECT_FALSE(ref::biarc(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitX()));
    EXPECT_FALSE(ref::biarc(Vec3::Zero(), Vec3::UnitX(), Vec3(1, 0, 0), -Vec3::UnitX()));
}

class ArcFits : public testing::TestWithParam<double> {};

TEST_P(ArcFits, KeepTheToleranceWithOneTangentAtEveryJoint) {
    std::mt19937 random(7);
    const double tolerance = GetParam();
    double nearest = 1;
    for (int i = 0; i < 40; ++i) {
        const Cubic cubic = random_cubic(random, i % 3 == 0);
        const ArcFit fit = ref::fit_arcs(cubic, tolerance);
        EXPECT_LE(fit.deviation, tolerance);
        const RationalBezier curve = curve_of(cubic);
        const CurveDistance distance(curve);
        double seen = 0;
        Vec3 at = cubic.position(0);
        Vec3 along = ref::tangent(cubic, 0);
        for (const TangentArc& arc : fit.arcs) {
            EXPECT_EQ(arc.start, at);
            // A line in place of an all but straight arc turns by 4 kFlatRise over its length.
            const double turn = 1e-11 + 8 * ref::kFlatRise / arc.length();
            if (arc.length() > tolerance) {
                EXPECT_LE((arc.tangent - along).norm(), turn);
            }
            EXPECT_LE((arc.at(arc.length()) - arc.end).norm(), 1e-12);
            for (int k = 1; k <= 8; ++k) {
                seen = std::max(seen, distance.of(arc.at(arc.length() * k / 8)));
            }
            at = arc.end;
            along = end_tangent(arc);
        }
        EXPECT_LE((at - cubic.position(1)).norm(), 1e-13);
        EXPECT_LE(seen, fit.deviation + 1e-9);
        nearest = std::min(nearest, fit.deviation / tolerance);
        // The bound is not idle: biarcs at half the distance would need more pieces.
        EXPECT_GE(fit.deviation, 0.3 * tolerance);
        EXPECT_GE(seen, 0.3 * fit.deviation) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Tolerances, ArcFits, testing::Values(1e-4, 1e-3, 1e-2),
                         [](const auto& tolerance) {
                             return std::to_string(std::lround(tolerance.param * 1e6)) + "nm";
                         });

TEST(ArcFit, GrowsWithTheCubeRootOfTheTolerance) {
    std::mt19937 random(3);
    std::size_t coarse = 0;
    std::size_t fine = 0;
    std::size_t chords = 0;
    for (int i = 0; i < 50; ++i) {
        const Cubic cubic = random_cubic(random, false);
        coarse += ref::fit_arcs(cubic, 1e-3).arcs.size();
        fine += ref::fit_arcs(cubic, 1e-6).arcs.size();
        chords += ref::fit_chords(cubic, 1e-3).size() - 1;
    }
    const double ratio = static_cast<double>(fine) / static_cast<double>(coarse);
    EXPECT_GE(ratio, 7);  // of chords: 32
    EXPECT_LE(ratio, 10.5);
    EXPECT_LT(2 * coarse, chords);
}

TEST(ArcFit, OfALineIsOneLine) {
    const Cubic line = ref::from_bezier({Vec3(0, 0, 0), Vec3(1, 2, 0), Vec3(2, 4, 0), {3, 6, 0}});
    const ArcFit fit = ref::fit_arcs(line, 1e-3);
    ASSERT_EQ(fit.arcs.size(), 1U);
    EXPECT_EQ(fit.arcs[0].angle, 0);
    EXPECT_EQ(ref::fit_chords(line, 1e-3).size(), 2U);
}

TEST(ArcFit, GoesThroughACuspAndFromADoubledPoint) {
    for (const Cubic& cubic :
         {ref::from_bezier({Vec3(0, 0, 0), {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}),
          ref::from_bezier({Vec3(0, 0, 0), {0, 0, 0}, {4, 1, 0}, {5, 5, 2}}),
          ref::from_bezier({Vec3(0, 0, 0), {9, 0, 0}, {-6, 0, 0}, {3, 0, 0}})}) {
        const ArcFit fit = ref::fit_arcs(cubic, 1e-3);
        EXPECT_LE(fit.deviation, 1e-3);
        EXPECT_LE(fit.arcs.size(), 60U);
        EXPECT_EQ(fit.arcs.front().start, cubic.position(0));
        EXPECT_EQ(fit.arcs.back().end, cubic.position(1));
        const RationalBezier curve = curve_of(cubic);
        const CurveDistance distance(curve);
        for (const TangentArc& arc : fit.arcs) {
            for (int k = 1; k <= 4; ++k) {
                EXPECT_LE(distance.of(arc.at(arc.length() * k / 4)), fit.deviation + 1e-9);
            }
        }
    }
}

TEST(Chords, KeepTheToleranceAndNoMore) {
    std::mt19937 random(11);
    for (int i = 0; i < 20; ++i) {
        const Cubic cubic = random_cubic(random, false);
        const std::vector<double> u = ref::fit_chords(cubic, 1e-3);
        double worst = 0;
        for (std::size_t k = 1; k < u.size(); ++k) {
            const Vec3 from = cubic.position(u[k - 1]);
            const Vec3 chord = (cubic.position(u[k]) - from).normalized();
            for (int part = 1; part < 8; ++part) {
                const Vec3 arm = cubic.position(u[k - 1] + (u[k] - u[k - 1]) * part / 8) - from;
                worst = std::max(worst, arm.cross(chord).norm());
            }
        }
        EXPECT_LE(worst, 1e-3);
        EXPECT_GE(worst, 0.3e-3);
    }
}

TEST(SplineForm, LeavesEndsAxesAndStopsWhereTheyWere) {
    std::mt19937 random(5);
    ref::Program program;
    Move move;
    move.end = Vec3(1, 0, 0);
    program.moves.push_back(move);
    move.kind = Move::Kind::kCubic;
    move.cubic = random_cubic(random, false);
    move.start = move.cubic.position(0);
    move.end = move.cubic.position(1) + Vec3(0, 1e-9, 0);
    move.line = 7;
    move.feed = 20;
    move.aux_start[2] = 5;
    move.aux_end[2] = 9;
    move.exact_stop = true;
    move.dwell = 0.5;
    program.moves.push_back(move);
    for (const ref::SplineForm form : {ref::SplineForm::kArcs, ref::SplineForm::kChords}) {
        ref::Program replaced = program;
        const ref::Replaced found = ref::replace_splines(replaced, form, 1e-3);
        EXPECT_EQ(found.splines, 1U);
        ASSERT_EQ(replaced.moves.size(), found.moves + 1);
        EXPECT_EQ(replaced.moves[1].start, move.start);
        EXPECT_EQ(replaced.moves[1].aux_start, move.aux_start);
        EXPECT_EQ(replaced.moves.back().end, move.end);
        EXPECT_EQ(replaced.moves.back().aux_end, move.aux_end);
        double rate = 0;
        for (std::size_t i = 1; i < replaced.moves.size(); ++i) {
            const Move& piece = replaced.moves[i];
            const bool last = i + 1 == replaced.moves.size();
            EXPECT_NE(piece.kind, Move::Kind::kCubic);
            EXPECT_EQ(piece.exact_stop, last);
            EXPECT_EQ(piece.dwell, last ? 0.5 : 0);
            EXPECT_EQ(piece.line, 7);
            EXPECT_EQ(piece.feed, 20);
            if (!last) {
                EXPECT_EQ(piece.end, replaced.moves[i + 1].start);
                EXPECT_EQ(piece.aux_end, replaced.moves[i + 1].aux_start);
            }
            const double here = (piece.aux_end[2] - piece.aux_start[2]) / piece.length();
            if (i > 1) {
                EXPECT_NEAR(here, rate, 1e-9);
            }
            rate = here;
        }
    }
    ref::Program same = program;
    EXPECT_EQ(ref::replace_splines(same, ref::SplineForm::kSpline, 1e-3).splines, 0U);
    EXPECT_EQ(same.moves[1].kind, Move::Kind::kCubic);
}

}  // namespace curvecore::tb::arc_fit_test
