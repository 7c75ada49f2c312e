// SPDX-License-Identifier: Apache-2.0
// Network tables against closed forms, in 100 digits and in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <string>

#include "ref/curve/great_circle.hpp"
#include "ref/series/figures.hpp"
#include "ref/series/interpreter.hpp"

namespace curvecore::ref::network_test {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
using Vector = Eigen::Matrix<Real, 3, 1>;

constexpr int kOrder = 14;

// An orthonormal frame: B, and the start r0 / R in its plane.
template <class T>
Eigen::Matrix<T, 3, 1> normal() {
    return Eigen::Matrix<T, 3, 1>(T(2), T(-2), T(1)) / T(3);
}
template <class T>
Eigen::Matrix<T, 3, 1> unit_start() {
    return Eigen::Matrix<T, 3, 1>(T(1), T(2), T(2)) / T(3);
}

template <class T>
std::array<T, 6> spherical_state(const T& radius) {
    const Eigen::Matrix<T, 3, 1> r = unit_start<T>() * radius;
    const Eigen::Matrix<T, 3, 1> f = normal<T>().cross(r);
    return {r[0], f[0], r[1], f[1], r[2], f[2]};
}

template <class T>
Eigen::Matrix<T, 3, 1> position(const std::array<T, 6>& state) {
    return {state[0], state[2], state[4]};
}

// Error that a truncated series may leave after `steps` steps of `angle` on a circle of radius R.
Real truncation(const Real& radius, const Real& angle, int order, int steps) {
    Real term = radius;
    for (int i = 1; i <= order + 1; ++i) {
        term *= angle / i;
    }
    return 2 * term * steps;
}

TEST(Network, SineCosineCoefficientsAreReciprocalFactorials) {
    const auto series = interpret<Real>(kSineCosine, 40).expand({Real(0), Real(1)});
    Real factorial(1);
    for (int i = 1; i <= 40; ++i) {
        factorial *= i;
        const bool odd = i % 2 == 1;
        const Real sign(i % 4 < 2 ? 1 : -1);
        const auto at = static_cast<std::size_t>(i);
        EXPECT_LT(abs(series[0][at] * factorial - (odd ? sign : Real(0))), Real("1e-98")) << i;
        EXPECT_LT(abs(series[1][at] * factorial - (odd ? Real(0) : sign)), Real("1e-98")) << i;
    }
}

TEST(Network, SineCosineFollowsTheClosedFormOverATurn) {
    auto network = interpret<Real>(kSineCosine, kOrder);
    constexpr int kSteps = 512;
    const Real h = boost::math::constants::two_pi<Real>() / kSteps;
    const Real x0(0.3);
    std::array<Real, 2> state{sin(x0), cos(x0)};
    Real worst(0);
    for (int n = 1; n <= kSteps; ++n) {
        state = network.step(state, h);
        worst = std::max(worst, Real(abs(state[0] - sin(x0 + n * h))));
        worst = std::max(worst, Real(abs(state[1] - cos(x0 + n * h))));
    }
    const Real bound = truncation(Real(1), h, kOrder, kSteps);
    EXPECT_LE(worst, bound);
    EXPECT_GT(worst, bound / 8) << "the bound is idle";
    EXPECT_LT(worst, Real("1e-35"));
    EXPECT_LT(abs(state[0] * state[0] + state[1] * state[1] - 1), Real("1e-35"));
}

// Order P leaves a radius that grows for P = 1, 2 mod 4 and shrinks for P = 3, 4 mod 4.
TEST(Network, OneStepRadiusErrorHasTheDerivedSizeAndSign) {
    constexpr std::array<double, 12> kReciprocal{2.0,     8.0,      -24.0,      -144.0,
                                                 720.0,   5760.0,   -40320.0,   -403200.0,
                                                 3628800, 43545600, -479001600, -6706022400};
    const Real h("1e-4");
    for (int order = 1; order <= 12; ++order) {
        const auto state = interpret<Real>(kSineCosine, order).step({Real(0), Real(1)}, h);
        const Real radius = sqrt(state[0] * state[0] + state[1] * state[1]);
        const int power = order % 2 == 1 ? order + 1 : order + 2;
        const Real ratio = (radius - 1) / pow(h, power) * Real(kReciprocal[std::size_t(order - 1)]);
        EXPECT_LT(abs(ratio - 1), Real("1e-6")) << "order " << order << " ratio " << ratio;
    }
}

TEST(Network, SphericalFollowsTheGreatCircleOverATurn) {
    const Real radius(25);
    const GreatCircle<Real> circle(unit_start<Real>() * radius, normal<Real>());
    auto network = interpret<Real>(kSpherical, kOrder, {1 / radius});
    constexpr int kSteps = 512;
    const Real ds = boost::math::constants::two_pi<Real>() * radius / kSteps;
    auto state = spherical_state(radius);
    Real worst(0);
    for (int n = 1; n <= kSteps; ++n) {
        state = network.step(state, ds);
        worst = std::max(worst, Real((position(state) - circle.position(n * ds)).norm()));
        const Vector partner(state[1], state[3], state[5]);
        EXPECT_LT((partner / radius - circle.tangent(n * ds)).norm(), Real("1e-34"));
        EXPECT_LT(abs(normal<Real>().dot(position(state))), Real("1e-90"));
    }
    const Real bound = truncation(radius, ds / radius, kOrder, kSteps);
    EXPECT_LE(worst, bound);
    EXPECT_GT(worst, bound / 8) << "the bound is idle";
    EXPECT_LT(worst, Real("1e-33"));
}

TEST(Network, DoubleFollowsHighPrecisionToItsRoundings) {
    constexpr double kRadius = 25;
    constexpr int kSteps = 1000;
    constexpr double kStep = 0.25;
    for (const int order : {2, 4, 6, 10, 14}) {
        auto fine = interpret<Real>(kSpherical, order, {1 / Real(kRadius)});
        auto coarse = interpret<double>(kSpherical, order, {1 / kRadius});
        auto exact = spherical_state(Real(kRadius));
        auto state = spherical_state(kRadius);
        double worst = 0;
        for (int n = 0; n < kSteps; ++n) {
            exact = fine.step(exact, Real(kStep));
            state = coarse.step(state, kStep);
            for (std::size_t i = 0; i < state.size(); ++i) {
                worst = std::max(worst, std::abs(static_cast<double>(exact[i] - Real(state[i]))));
            }
        }
        // A step rounds its last addition to half an ulp of R and 1 / R to 2^-53 of the angle.
        const double per_step = kRadius * std::ldexp(1.0, -52);
        EXPECT_LT(worst, kSteps * per_step) << "order " << order;
        EXPECT_GT(worst, 1e-3 * kSteps * per_step) << "order " << order;
    }
}

TEST(Network, WrongSignFailsTheClosedForm) {
    const Real radius(25);
    const GreatCircle<Real> circle(unit_start<Real>() * radius, normal<Real>());
    const Real ds("0.25");
    for (std::size_t wrong = 0; wrong < kSpherical.size(); ++wrong) {
        auto mutant = kSpherical;
        mutant.nodes[wrong].gain.factor *= -1;
        const auto state =
            interpret<Real>(mutant, kOrder, {1 / radius}).step(spherical_state(radius), ds);
        EXPECT_GT((position(state) - circle.position(ds)).norm(), Real("1e-4"))
            << "node " << mutant.nodes[wrong].output;
    }
}

// The general nodes: [Chikurov] Fig. 3, y = 1 / (k (t0 + t)), feeds a Stieltjes integrator with its
// own integrand.
TEST(Network, StieltjesIntegratorDrawsTheHyperbola) {
    const Real k("0.7");
    const Real t0(2);
    const Real y0 = 1 / (k * t0);
    auto network = interpret<Real>(kHyperbola, 20, {k});
    const auto series = network.expand({y0, -k * y0 * y0});
    Real expected = y0;
    for (std::size_t i = 0; i <= 20; ++i) {
        EXPECT_LT(abs(series[0][i] - expected), Real("1e-98")) << i;
        expected /= -t0;
    }
}

// Stieltjes, scalers and a sum, listed against the order in which they must be evaluated:
// A = u^3, P = A + W + V with W = 4 u, V = u^2 / 2 and u = exp(s).
constexpr Network<6, 1> kMixed{
    "mixed",
    "s",
    {"four"},
    {{sum("P", "A", "W", "V"), stieltjes("A", "B", "u", {3}), stieltjes("B", "u", "u", {2}),
      stieltjes("V", "u", "u"), scaler("W", "u", {1, "four"}), riemann("u", "u", "s")}}};

TEST(Network, EvaluationFollowsIntegratingVariablesAndAddends) {
    constexpr std::array<std::size_t, 6> kOrderOfNodes = evaluation_order(kMixed);
    EXPECT_EQ(kOrderOfNodes, (std::array<std::size_t, 6>{5, 1, 2, 3, 4, 0}));
    auto network = interpret<Real>(kMixed, 40, {Real(4)});
    const Real half("0.5");
    const auto state = network.step({Real("5.5"), Real(1), Real(1), half, Real(4), Real(1)}, half);
    const Real u = exp(half);
    const std::array<Real, 6> expected{
        u * u * u + 4 * u + u * u / 2, u * u * u, u * u, u * u / 2, 4 * u, u};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LT(abs(state[i] - expected[i]), Real("1e-35")) << kMixed.nodes[i].output;
    }
}

std::string refusal(const Network<2, 1>& network) {
    try {
        evaluation_order(network);
    } catch (const std::logic_error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Network, ImpossibleWiringIsRefused) {
    const Node y = riemann("y", "y", "s");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, scaler("z", "y", {2, "k"})}}}), "accepted");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, scaler("z", "y", {2, "l"})}}}),
              "a gain names no parameter of its network");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, scaler("z", "w", {2})}}}),
              "a node's input is no output of its network");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, riemann("z", "w", "s")}}}),
              "a node's input is no output of its network");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, sum("z", "y", "y", "w")}}}),
              "a node's input is no output of its network");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, riemann("z", "y", "y")}}}),
              "a Riemann integrator runs on the independent variable");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{y, y}}}), "two nodes drive the same output");
    EXPECT_EQ(refusal({"", "s", {"k"}, {{stieltjes("y", "y", "z"), stieltjes("z", "y", "y")}}}),
              "the network has an algebraic loop");
    EXPECT_THROW(interpret<double>(kSineCosine, 0), std::invalid_argument);
}

}  // namespace curvecore::ref::network_test
