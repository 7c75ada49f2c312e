// SPDX-License-Identifier: Apache-2.0
// A table's curve in a program: how its rows grow with the step, the exact curve by its series, its
// stretches and segments, against closed forms and integrals.
#include "ref/curve/drawn/table_curve.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <random>

#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/limits/limits.hpp"
#include "ref/limits/table_shape.hpp"
#include "ref/limits/travel.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/segment/table_segment.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::table_curve_test {

using ref::TableCurve;
using ref::TablePiece;
using ref::Vec3;

const ref::CurveTable& clothoid() {
    static const ref::CurveTable kTable = [] {
        ref::CurveTable table = ref::read_curve_table(std::string(CURVES_DIR) + "/clothoid.net");
        table.powers = ref::row_powers(table);
        return table;
    }();
    return kTable;
}

/// A clothoid of curvature kappa and its change sigma, 1/mm and 1/mm^2, in the plane of t and n.
struct Clothoid {
    Vec3 start, t, n;
    double kappa, sigma, length;

    TablePiece piece() const {
        TablePiece piece;
        piece.table = &clothoid();
        piece.theta = sigma;
        piece.tangent = t;
        piece.normal = n;
        piece.advance = Vec3::Constant(kappa);
        return piece;
    }
    double turned(double s) const { return (kappa + sigma * s / 2) * s; }
    Vec3 direction(double s) const { return t * std::cos(turned(s)) + n * std::sin(turned(s)); }
    Vec3 position(double s) const {
        const boost::math::quadrature::gauss<double, 15> gauss;
        Vec3 place = start;
        constexpr int kParts = 64;
        for (int axis = 0; axis < 3; ++axis) {
            for (int part = 0; part < kParts; ++part) {
                place[axis] += gauss.integrate([&](double at) { return direction(at)[axis]; },
                                               s * part / kParts, s * (part + 1) / kParts);
            }
        }
        return place;
    }
    ref::Move move() const {
        ref::Move move;
        move.kind = ref::Move::Kind::kTable;
        move.line = 1;
        move.feed = 100;
        move.start = start;
        move.table = piece();
        move.table_length = length;
        move.end = position(length);
        return move;
    }
};

Clothoid random_clothoid(std::mt19937_64& random) {
    const auto real = [&](double most) {
        return std::uniform_real_distribution<double>(-most, most)(random);
    };
    Clothoid made;
    made.start = 100 * Vec3(real(1), real(1), real(1));
    made.t = Vec3(real(1), real(1), real(1)).normalized();
    made.n = made.t.cross(Vec3(real(1), real(1), real(1))).normalized();
    made.kappa = real(0.5);
    made.sigma = real(0.02);
    made.length = std::exp(real(2)) * 10;
    return made;
}

TEST(RowPowers, FollowFromTheLines) {
    const std::map<std::string, int> powers{{"T", 0}, {"N", 0}, {"kappa", 1}, {"sigma", 2}};
    EXPECT_EQ(clothoid().powers, powers);
}

TEST(RowPowers, ALineWhoseTermsGrowOtherwiseIsNamed) {
    const auto refusal = [](const std::string& line, const std::string& gauge = "power N 0\n") {
        const ref::CurveTable table = ref::read_curve_text(
            "c.net",
            "curve c\nword q -1  r -1\nstart T[3] -2  N[3] -2\n"
            "bus theta q  further.0 r  tangent T  normal N\n" +
                gauge +
                "output x\norder\n"
                "  DT[k] : -2 = q*N[k]'\n" +
                line +
                "\n  T[k] : -2 = DT[k]/i\n  N[k] : -2 = DN[k]/i\n  x[k] : -2 = T[k]'/i\n"
                "next\n  T[k] : -2 = T[k] + sum(T[k])\n  N[k] : -2 = N[k] + sum(N[k])\n"
                "  move[k] : -2 = sum(x[k])\n");
        try {
            ref::row_powers(table);
        } catch (const ref::InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal("  DN[k] : -2 = r*T[k]'"), "");
    EXPECT_NE(refusal("  DN[k] : -2 = r*T[k]'", "\n").find("open: `power"), std::string::npos)
        << "N may be any multiple: q and r the inverse ones";
    EXPECT_EQ(refusal("  DN[k] : -2 = q*T[k]' + r*T[k]'", "\n"), "") << "both grow alike";
    EXPECT_NE(refusal("  DN[k] : -2 = r*T[k]' + r*T[k]''").find("c.net:9: error: its terms"),
              std::string::npos);
    EXPECT_NE(refusal("  DN[k] : -2 = r/i").find("c.net:9: error:"), std::string::npos);
    EXPECT_NE(refusal("  DN[k] : -2 = r@T[k]'").find("order by order"), std::string::npos);
}

TEST(TableCurve, IsTheIntegralOfItsTangent) {
    std::mt19937_64 random(1);
    for (int n = 0; n < cases(40, 1000); ++n) {
        const Clothoid exact = random_clothoid(random);
        const TableCurve curve(exact.piece(), exact.start, exact.length);
        for (const double part : {0.0, 0.21, 0.5, 0.83, 1.0}) {
            const double s = part * exact.length;
            EXPECT_LT((curve.position(s) - exact.position(s)).norm(), 1e-12 * (100 + exact.length));
            EXPECT_LT((curve.direction(s) - exact.direction(s)).norm(), 1e-12);
            const double kappa = exact.kappa + exact.sigma * s;
            EXPECT_NEAR(curve.curvature(s), std::abs(kappa), 1e-11);
            // r''' = sigma N - kappa^2 T
            EXPECT_NEAR(curve.bend_rate(s).norm(), std::hypot(exact.sigma, kappa * kappa), 1e-10);
        }
    }
}

/// A part of a move is the same curve: the start rows are those of its place.
TEST(TableCurve, GoesOnFromAnyPlace) {
    std::mt19937_64 random(2);
    for (int n = 0; n < cases(40, 1000); ++n) {
        const Clothoid exact = random_clothoid(random);
        const ref::Move part = ref::part_of(exact.move(), 0.3 * exact.length, 0.9 * exact.length);
        const TableCurve rest(part.table, part.start, part.table_length);
        EXPECT_NEAR(rest.length(), 0.6 * exact.length, 1e-12 * exact.length);
        EXPECT_LT((rest.position(rest.length()) - exact.position(0.9 * exact.length)).norm(),
                  1e-12 * (100 + exact.length));
        EXPECT_LT((rest.direction(0.2) - exact.direction(0.3 * exact.length + 0.2)).norm(), 1e-12);
        // In other units
        const TableCurve inches(part.table.rescaled(1 / 25.4), part.start / 25.4,
                                part.table_length / 25.4);
        EXPECT_LT((25.4 * inches.position(inches.length()) - rest.position(rest.length())).norm(),
                  1e-12 * (100 + exact.length));
    }
}

/// The bound of a derivative at a step's start is that of the step which begins there.
TEST(TableCurve, BoundsTheStepBehindEachEnd) {
    std::mt19937_64 random(5);
    int steps = 0;
    for (int n = 0; n < cases(100, 1000); ++n) {
        const Clothoid exact = random_clothoid(random);
        const TableCurve curve(exact.piece(), exact.start, exact.length);
        const std::vector<double> ends = curve.step_ends();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double middle = (ends[i] + ends[i + 1]) / 2;
            EXPECT_EQ(curve.most_derivative(ends[i], 2), curve.most_derivative(middle, 2)) << i;
            ++steps;
        }
    }
    EXPECT_GT(steps, 500);
}

TEST(TableCurve, WithoutConvergenceIsRefused) {
    Clothoid wild{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 1e6, 0, 10};
    EXPECT_THROW(TableCurve(wild.piece(), wild.start, wild.length), std::domain_error);
}

TEST(TableShape, BoundsEveryPlaceOfItsStretch) {
    std::mt19937_64 random(3);
    const ref::Machine machine;
    double tightest = 1;
    for (int n = 0; n < cases(20, 500); ++n) {
        const Clothoid exact = random_clothoid(random);
        const ref::Move move = exact.move();
        const TableCurve curve(move.table, move.start, move.table_length);
        double from = 0;
        for (const ref::TableStretch& stretch :
             ref::table_stretches(move, curve, machine, 0, exact.length)) {
            ASSERT_EQ(stretch.from, from);
            from = stretch.to;
            double sharpest = 0;
            for (int i = 0; i <= 50; ++i) {
                const double s = stretch.from + (stretch.to - stretch.from) * i / 50;
                const double kappa = std::abs(exact.kappa + exact.sigma * s);
                sharpest = std::max(sharpest, kappa);
                ASSERT_LE(kappa, stretch.shape.curvature + 1e-12);
                ASSERT_LE(std::abs(exact.sigma), stretch.shape.swerve + 1e-12);
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_LE(std::abs(exact.direction(s)[axis]),
                              stretch.shape.along[static_cast<std::size_t>(axis)] + 1e-12);
                }
            }
            tightest = std::min(tightest, sharpest / stretch.shape.curvature);
        }
        ASSERT_EQ(from, exact.length);
        // What it travels
        const ref::AxisRange range = ref::travel(move);
        for (int i = 0; i <= 200; ++i) {
            const Vec3 place = exact.position(exact.length * i / 200);
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(place[axis], range.low[static_cast<std::size_t>(axis)] - 1e-9);
                ASSERT_LE(place[axis], range.high[static_cast<std::size_t>(axis)] + 1e-9);
            }
        }
    }
    EXPECT_GT(tightest, 0.3) << "of the bound";
}

TEST(TableSegment, KeepsTheBoundAndJoins) {
    std::mt19937_64 random(4);
    const double unit = 1e-6;
    for (int n = 0; n < cases(4, 50); ++n) {
        Clothoid exact = random_clothoid(random);
        exact.length = std::min(exact.length, 30.0);
        const TableCurve curve(exact.piece().rescaled(1 / unit), exact.start / unit,
                               exact.length / unit);
        ref::PlanOptions options;
        const auto segments = ref::cut_table(curve, options);
        double s = 0;
        Vec3 at = exact.start / unit;
        for (const ref::Segment& segment : segments) {
            EXPECT_LE(segment.bound, options.error_limit / 2);
            EXPECT_GT(segment.bound, 0);
            EXPECT_LT((segment.start - at).norm(), 1e-6);
            const double length = std::ldexp(static_cast<double>(segment.length), -16);
            s += length;
            at = segment.end;
            const auto path = segment.table().path(segment.start, length);
            EXPECT_LT((path->position(length) - segment.end).norm(), 1e-3);
            EXPECT_LT((segment.end - exact.position(s * unit) / unit).norm(), 1e-2);
        }
        EXPECT_NEAR(s, exact.length / unit, 1);
        EXPECT_LT(segments.size(), 12U);
        // Narrow words take shorter steps or more segments, or are refused.
        options.format.coef_bits = 20;
        EXPECT_THROW(ref::cut_table(curve, options), std::domain_error);
    }
}

}  // namespace curvecore::tb::table_curve_test
