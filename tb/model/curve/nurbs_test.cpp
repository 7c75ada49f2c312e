// SPDX-License-Identifier: Apache-2.0
// NURBS as cubics: spans against the definition in high precision, fits against the exact curve.
#include "ref/curve/fit/nurbs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "ref/curve/fit/cubic_fit.hpp"
#include "ref/program/gcode_reader.hpp"
#include "tb/support/judge/curve_distance.hpp"

namespace curvecore::ref::nurbs_test {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

/// Basis function of Cox and de Boor by its definition.
Real basis(int i, int degree, const Real& u, const std::vector<double>& knots) {
    if (u < knots[i] || u > knots[i + degree + 1]) return 0;
    if (degree == 0) {
        const bool last = knots[i + 1] == knots.back();
        const bool within = knots[i] <= u && u < knots[i + 1];
        return within || (last && knots[i] < u && u == knots[i + 1]) ? 1 : 0;
    }
    Real sum = 0;
    if (knots[i + degree] > knots[i]) {
        sum +=
            (u - knots[i]) / (Real(knots[i + degree]) - knots[i]) * basis(i, degree - 1, u, knots);
    }
    if (knots[i + degree + 1] > knots[i + 1]) {
        sum += (knots[i + degree + 1] - u) / (Real(knots[i + degree + 1]) - knots[i + 1]) *
               basis(i + 1, degree - 1, u, knots);
    }
    return sum;
}

Vec3 definition(const Nurbs& nurbs, const Real& u) {
    const int count = static_cast<int>(nurbs.points.size());
    std::vector<double> knots = nurbs.knots;  // none: LinuxCNC's
    for (int i = 0; nurbs.knots.empty() && i < count + nurbs.order; ++i) {
        knots.push_back(std::clamp(i - nurbs.order + 1, 0, count - nurbs.order + 1));
    }
    std::array<Real, 4> sum{};
    for (int i = 0; i < count; ++i) {
        const Real part = basis(i, nurbs.order - 1, u, knots) * nurbs.weights[i];
        for (int axis = 0; axis < 3; ++axis) sum[axis] += part * nurbs.points[i][axis];
        sum[3] += part;
    }
    return {static_cast<double>(Real(sum[0] / sum[3])), static_cast<double>(Real(sum[1] / sum[3])),
            static_cast<double>(Real(sum[2] / sum[3]))};
}

Nurbs random_nurbs(std::mt19937& random, int order, int count, bool weighted, bool flat = false) {
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    Nurbs nurbs;
    nurbs.order = order;
    for (int i = 0; i < count; ++i) {
        nurbs.points.emplace_back(10 * i + uniform(-10, 10), uniform(-20, 20),
                                  flat ? 0 : uniform(-20, 20));
        nurbs.weights.push_back(weighted ? std::exp(uniform(-2, 2)) : 1);
    }
    return nurbs;
}

TEST(Nurbs, SpansAreTheCurveOfTheDefinition) {
    std::mt19937 random(1);
    for (int order = 2; order <= 8; ++order) {
        for (const bool weighted : {false, true}) {
            const Nurbs nurbs = random_nurbs(random, order, order + 4, weighted);
            const std::vector<RationalBezier> found = spans(nurbs);
            ASSERT_EQ(found.size(), 5U);
            for (std::size_t i = 0; i < found.size(); ++i) {
                for (const double t : {0.0, 0.125, 0.5, 0.9375, 1.0}) {
                    const double miss =
                        (found[i].at(t).position - definition(nurbs, Real(i) + Real(t))).norm();
                    EXPECT_LE(miss, 1e-13) << "order " << order << " span " << i << " t " << t;
                }
            }
        }
    }
}

TEST(Nurbs, SpansOfAnyKnotsAreTheCurveOfTheDefinition) {
    std::mt19937 random(6);
    int repeated = 0;
    for (int round = 0; round < 60; ++round) {
        const int order = 2 + round % 6;
        Nurbs nurbs = random_nurbs(random, order, order + 6, round % 2 == 0);
        std::vector<double> inside;
        for (int i = 0; i < 6; ++i) inside.push_back(static_cast<double>(random() % 1000) / 7);
        if (order > 2) inside[1] = inside[0];
        if (order > 3) inside[2] = inside[0];
        std::sort(inside.begin(), inside.end());
        nurbs.knots.assign(order, -3.5);
        nurbs.knots.insert(nurbs.knots.end(), inside.begin(), inside.end());
        nurbs.knots.insert(nurbs.knots.end(), order, 150);
        if (!why_no_knots(nurbs).empty()) continue;
        const std::vector<RationalBezier> found = spans(nurbs);
        std::vector<double> ends = nurbs.knots;
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        ASSERT_EQ(found.size() + 1, ends.size());
        repeated += ends.size() < 8;
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (const double t : {0.0, 0.125, 0.5, 0.9375, 1.0}) {
                const Real u = Real(ends[i]) + Real(t) * (Real(ends[i + 1]) - Real(ends[i]));
                EXPECT_LE((found[i].at(t).position - definition(nurbs, u)).norm(), 2e-13)
                    << "round " << round << " span " << i << " t " << t;
            }
        }
    }
    EXPECT_GT(repeated, 30);
}

/// Distance from the curve by its definition, found by search over all of it and then by halving,
/// without spans or fits.
double distance_from(const Nurbs& nurbs, const std::vector<std::pair<double, Vec3>>& samples,
                     const Vec3& point) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if ((samples[i].second - point).norm() < (samples[nearest].second - point).norm()) {
            nearest = i;
        }
    }
    double low = samples[nearest == 0 ? 0 : nearest - 1].first;
    double high = samples[std::min(nearest + 1, samples.size() - 1)].first;
    const auto far = [&](double u) { return (definition(nurbs, Real(u)) - point).norm(); };
    for (int i = 0; i < 40; ++i) {
        const double third = (high - low) / 3;
        if (far(low + third) < far(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return far((low + high) / 2);
}

/// Control points, weights and knots of the file's words, read here independently.
Nurbs nurbs_of(const std::string& file) {
    Nurbs nurbs;
    nurbs.order = 4;
    std::ifstream lines(file);
    Vec3 at = Vec3::Zero();
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == ';') continue;
        std::map<char, double> words;
        std::istringstream text(line);
        for (std::string word; text >> word;) words[word[0]] = std::stod(word.substr(1));
        if (words.count('X') != 0) at = Vec3(words['X'], words['Y'], 0);
        if (words.count('P') != 0) {
            nurbs.points.push_back(at);
            nurbs.weights.push_back(words['P']);
        }
        if (words.count('K') != 0) nurbs.knots.push_back(words['K']);
    }
    return nurbs;
}

TEST(Nurbs, TheButterflyIsDrawnWithinItsTolerance) {
    const std::string file = DATA_DIR "/butterfly.ngc";
    const Nurbs nurbs = nurbs_of(file);
    ASSERT_EQ(nurbs.points.size(), 51U);
    ASSERT_EQ(nurbs.knots.size(), 55U);
    std::vector<std::pair<double, Vec3>> samples;
    for (int i = 0; i <= 2000; ++i) {
        samples.emplace_back(i / 2000.0, definition(nurbs, Real(i) / 2000));
    }
    const Program program = read_gcode(file);
    double worst = 0;
    double length = 0;
    int drawn = 0;
    for (const Move& move : program.moves) {
        if (move.rapid) continue;
        length += move.length();
        if (drawn++ % 4 != 0) continue;  // some of the pieces: each point takes long
        for (const double u : {0.15, 0.4, 0.7, 0.9}) {
            worst = std::max(worst, distance_from(nurbs, samples, move.cubic.position(u)));
        }
    }
    EXPECT_LE(worst, kFitTolerance);
    EXPECT_GT(worst, kFitTolerance / 1000);
    double polygon = 0;  // the reverse distance: no part of the curve is left out
    for (std::size_t i = 1; i < samples.size(); ++i) {
        polygon += (samples[i].second - samples[i - 1].second).norm();
    }
    EXPECT_NEAR(length, polygon, 1e-3 * polygon);
    EXPECT_GE(length, polygon);
    EXPECT_EQ(program.moves.front().end, nurbs.points.front());
    EXPECT_EQ(program.moves.back().end, nurbs.points.back());
    RecordProperty("pieces", drawn);
    RecordProperty("mm", std::to_string(length));
    RecordProperty("worst, nm", std::to_string(worst * 1e6));
}

TEST(Nurbs, DerivativeIsThatOfThePosition) {
    std::mt19937 random(2);
    const RationalBezier span = spans(random_nurbs(random, 5, 7, true))[1];
    for (const double t : {0.1, 0.5, 0.8}) {
        const double h = 1e-5;
        const Vec3 difference = (span.at(t + h).position - span.at(t - h).position) / (2 * h);
        EXPECT_LE((difference - span.at(t).derivative).norm(), 1e-6);
    }
}

TEST(Nurbs, PolynomialsUpToDegreeThreeAreExact) {
    std::mt19937 random(3);
    for (int order = 2; order <= 4; ++order) {
        Nurbs nurbs = random_nurbs(random, order, 9, false);
        for (double& weight : nurbs.weights) weight = 2.5;
        const std::vector<Cubic> cubics = cubics_of(nurbs, kFitTolerance);
        ASSERT_EQ(cubics.size(), nurbs.points.size() - order + 1);
        for (std::size_t i = 0; i < cubics.size(); ++i) {
            for (const double u : {0.0, 0.25, 0.6875, 1.0}) {
                EXPECT_LE((cubics[i].position(u) - definition(nurbs, Real(i) + Real(u))).norm(),
                          1e-13)
                    << "order " << order << " span " << i << " u " << u;
            }
        }
    }
}

TEST(Nurbs, CubicSplineHasNoJumpInItsCurvature) {
    std::mt19937 random(4);
    const std::vector<Cubic> cubics = cubics_of(random_nurbs(random, 4, 9, false), kFitTolerance);
    for (std::size_t i = 1; i + 1 < cubics.size(); ++i) {  // the first and last knots span alike
        EXPECT_LE((cubics[i].velocity(0) - cubics[i - 1].velocity(1)).norm(), 1e-12);
        EXPECT_LE((cubics[i].acceleration(0) - cubics[i - 1].acceleration(1)).norm(), 1e-12);
    }
}

TEST(Nurbs, LineWithWeightsStaysAStraightLine) {
    Nurbs nurbs{2, {Vec3(1, 2, 3), Vec3(5, -4, 3), Vec3(7, 7, 7)}, {1, 0.01, 5}};
    const std::vector<Cubic> cubics = cubics_of(nurbs, kFitTolerance);
    ASSERT_EQ(cubics.size(), 2U);
    EXPECT_LE((cubics[0].position(0.5) - Vec3(3, -1, 3)).norm(), 1e-15);
    EXPECT_LE((cubics[1].position(1) - Vec3(7, 7, 7)).norm(), 1e-14);
}

/// A quarter of the circle about 0.
std::vector<Cubic> quarter_circle(double radius, double tolerance) {
    return cubics_of({3,
                      {Vec3(radius, 0, 0), Vec3(radius, radius, 0), Vec3(0, radius, 0)},
                      {1, std::sqrt(0.5), 1}},
                     tolerance);
}

TEST(CubicFit, CircleStaysWithinItsTolerance) {
    for (const double radius : {0.01, 1.0, 10.0, 25.0, 1000.0}) {
        const std::vector<Cubic> cubics = quarter_circle(radius, kFitTolerance);
        double worst = 0;
        for (const Cubic& cubic : cubics) {
            for (int i = 0; i <= 1000; ++i) {
                worst = std::max(worst, std::abs(cubic.position(i / 1000.0).norm() - radius));
            }
        }
        EXPECT_LE(worst, kFitTolerance) << radius;
        EXPECT_GE(worst, kFitTolerance / 100) << radius << ": cut finer than needed";
        EXPECT_LE(cubics.size(), 16U) << radius;
        RecordProperty("pieces of a quarter", static_cast<int>(cubics.size()));
    }
}

TEST(CubicFit, ErrorFallsWithTheSixthPower) {
    const std::size_t coarse = quarter_circle(10, 1e-4).size();
    const std::size_t fine = quarter_circle(10, 1e-4 / 4096).size();
    EXPECT_EQ(fine, 4 * coarse);  // 4^6 = 4096
}

TEST(CubicFit, DistanceSeesTheErrorOfTheCommonQuarterCircle) {
    const double k = 4.0 / 3 * (std::sqrt(2.0) - 1);
    const Cubic cubic = from_bezier({Vec3(1, 0, 0), Vec3(1, k, 0), Vec3(k, 1, 0), Vec3(0, 1, 0)});
    RationalBezier circle;
    for (const auto& [x, y, w] :
         {std::array{1., 0., 1.}, std::array{1., 1., std::sqrt(0.5)}, std::array{0., 1., 1.}}) {
        circle.points.emplace_back(w * x, w * y, 0, w);
    }
    EXPECT_NEAR(distance(cubic, circle, 0, 1, 99), 2.725e-4, 1e-6);
}

TEST(CubicFit, RandomCurvesStayWithinTheirToleranceAndKeepTheirTangents) {
    std::mt19937 random(5);
    for (int n = 0; n < 12; ++n) {
        const int order = 3 + n % 5;
        const Nurbs nurbs = random_nurbs(random, order, order + 2, true, n % 2 == 0);
        for (const RationalBezier& span : spans(nurbs)) {
            const std::vector<Cubic> cubics = fit_cubics(span, kFitTolerance);
            const tb::CurveDistance exact(span);
            EXPECT_EQ(cubics.front().position(0), span.at(0).position);
            EXPECT_LE((cubics.back().position(1) - span.at(1).position).norm(), 1e-13);
            EXPECT_LE(cubics.size(), 200U);
            for (std::size_t i = 0; i < cubics.size(); ++i) {
                EXPECT_LE(exact.of(cubics[i]), kFitTolerance) << n;
                if (i == 0) continue;
                EXPECT_LE((cubics[i].position(0) - cubics[i - 1].position(1)).norm(), 1e-13);
                const Vec3 before = cubics[i - 1].velocity(1).normalized();
                EXPECT_LE(before.cross(cubics[i].velocity(0).normalized()).norm(), 1e-11) << n;
                EXPECT_GT(before.dot(cubics[i].velocity(0)), 0);
            }
        }
    }
}

TEST(CubicFit, CuspsAndFarApartWeightsEndWithinTheTolerance) {
    const Cubic whole =
        from_bezier({Vec3(0, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0), Vec3(10, 0, 0)});
    EXPECT_TRUE(has_cusp(whole));
    const Bezier part = to_bezier(sub_cubic(whole, 0, 0.8));  // the cusp is at t = 5/8 of it
    RationalBezier cusp;
    for (const Vec3& point : part) cusp.points.emplace_back(point.x(), point.y(), point.z(), 1);
    EXPECT_EQ(fit_cubics(cusp, kFitTolerance).size(), 1U) << "it is a cubic";
    RationalBezier moebius = cusp;  // the same points at t / (1.7 - 0.7 t)
    for (int i = 0; i < 4; ++i) moebius.points[i] *= std::pow(1.7, i);
    const std::vector<Cubic> pieces = fit_cubics(moebius, kFitTolerance);
    const tb::CurveDistance exact(cusp);
    for (const Cubic& piece : pieces) EXPECT_LE(exact.of(piece), kFitTolerance);
    EXPECT_GE(pieces.size(), 4U);
    EXPECT_LE(pieces.size(), 200U);
    const Nurbs steep{4,
                      {Vec3(0, 0, 0), Vec3(10, 40, 0), Vec3(20, -30, 0), Vec3(30, 5, 0)},
                      {1e-9, 1e9, 1, 1e-3}};
    EXPECT_LE(cubics_of(steep, kFitTolerance).size(), 2000U);
}

}  // namespace curvecore::ref::nurbs_test
