// SPDX-License-Identifier: Apache-2.0
// The spline's network against the exact curve by its path length, in 60 digits and in double, and
// the effect of the factor 6.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ref/curve/arc_length.hpp"
#include "ref/series/interpreter.hpp"
#include "ref/series/spline_state.hpp"
#include "tb/support/judge/precise_cubic.hpp"
#include "tb/support/segments/cubics.hpp"

namespace curvecore::ref::spline_network_test {

namespace node = spline_node;
using tb::Precise;
using tb::PreciseCubic;
using tb::RandomCubics;

// A curve in space, 20 mm long, with a speed ratio of 1.4.
Cubic gentle() {
    return from_bezier({Vec3(0, 0, 0), Vec3(7, 1, 0), Vec3(12, 5, 3), Vec3(16, 9, 7)});
}

template <class Real>
NetworkInterpreter<Real, kSpline.size(), 3> network(const Cubic& cubic, int order) {
    return {kSpline, order, spline_parameters<Real>(cubic)};
}

// R as the paper prints its recurrence.
auto without_six() {
    auto printed = kSpline;
    printed.nodes[node::kR].gain.factor = -1;
    return printed;
}

// The state after `path` from u0 on, by quadrature and Newton's method.
SplineState<Precise> exact_state(const Cubic& cubic, double u0, const Precise& path) {
    const ArcLength table(cubic);
    const double guess = table.parameter(table.path(u0) + static_cast<double>(path));
    const PreciseCubic exact(cubic);
    return spline_state(cubic,
                        exact.parameter(Precise(u0), path, Precise(guess), Precise("1e-54")));
}

Precise error(const SplineState<Precise>& state, const SplineState<Precise>& exact) {
    Precise worst(0);
    for (std::size_t n = 0; n < state.size(); ++n) {
        worst = std::max(worst, Precise(abs(state[n] - exact[n])));
    }
    return worst;
}

Precise position_error(const SplineState<Precise>& state, const SplineState<Precise>& exact) {
    Precise square(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const Precise miss = state[node::kX + k] - exact[node::kX + k];
        square += miss * miss;
    }
    return sqrt(square);
}

TEST(SplineNetwork, StartStateIsConsistent) {
    RandomCubics random(21);
    for (int n = 0; n < 100; ++n) {
        const Cubic cubic = random.bezier();
        const double u = random.uniform(0, 1);
        const SplineState<double> state = spline_state(cubic, u);
        const double v = cubic.speed(u);
        EXPECT_EQ(state[node::kU], u);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            EXPECT_NEAR(state[node::kW + k], cubic.acceleration(u)[axis], 1e-14);
            EXPECT_NEAR(state[node::kV + k], cubic.velocity(u)[axis], 1e-14);
            EXPECT_NEAR(state[node::kX + k], cubic.position(u)[axis], 1e-15);
        }
        EXPECT_NEAR(state[node::kSum], v * v / 2, 1e-14 * v * v);
        EXPECT_NEAR(state[node::kPhi] * v, 1, 1e-14);
        EXPECT_NEAR(state[node::kQ] * v * v * v, -1, 1e-14);
        EXPECT_NEAR(state[node::kR] * v * v, -3, 1e-14);
    }
}

TEST(SplineNetwork, EveryNodeFollowsTheExactCurve) {
    RandomCubics random(22);
    for (int n = 0; n < 6; ++n) {
        const Cubic cubic = n == 0 ? gentle() : n == 1 ? RandomCubics::hairpin(1) : random.bezier();
        const double u0 = n == 1 ? 0.4 : 0.3;
        const double h =
            std::ldexp(std::pow(cubic.speed(u0), 2) / cubic.acceleration(u0).norm(), -7);
        auto series = network<Precise>(cubic, 30);
        auto state = spline_state(cubic, Precise(u0));
        for (int i = 0; i < 3; ++i) {
            state = series.step(state, Precise(h));
        }
        EXPECT_LT(error(state, exact_state(cubic, u0, 3 * Precise(h))), Precise("1e-48")) << n;
    }
}

TEST(SplineNetwork, LocalErrorFallsWithTheOrder) {
    const Cubic cubic = gentle();
    const auto start = spline_state(cubic, Precise(0.3));
    for (const int order : {4, 6, 8, 12}) {
        auto series = network<Precise>(cubic, order);
        const auto error_of = [&](double h) {
            return position_error(series.step(start, Precise(h)),
                                  exact_state(cubic, 0.3, Precise(h)));
        };
        const auto ratio = static_cast<double>(error_of(0.0625) / error_of(0.03125));
        EXPECT_NEAR(std::log2(ratio), order + 1, 0.1) << order;
    }
}

// The first term that depends on it is u_4.
TEST(SplineNetwork, WithoutTheFactorSixTheLocalOrderIsFour) {
    const auto printed = without_six();
    const Cubic cubic = gentle();
    const auto start = spline_state(cubic, Precise(0.3));
    for (const int order : {4, 6, 8, 12}) {
        NetworkInterpreter<Precise, kSpline.size(), 3> wrong(printed, order,
                                                             spline_parameters<Precise>(cubic));
        const auto right = network<Precise>(cubic, order).expand(start)[node::kU];
        const auto terms = wrong.expand(start)[node::kU];
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_LT(abs(terms[i] - right[i]), Precise("1e-55")) << i;
        }
        EXPECT_NEAR(static_cast<double>(terms[4] / right[4] - 1), -8.4e-5, 0.1e-5);
        const auto error_of = [&](double h) {
            return position_error(wrong.step(start, Precise(h)),
                                  exact_state(cubic, 0.3, Precise(h)));
        };
        const auto ratio =
            static_cast<double>(error_of(std::ldexp(1, -12)) / error_of(std::ldexp(1, -13)));
        EXPECT_NEAR(std::log2(ratio), 4, order == 4 ? 0.15 : 0.01) << order;  // 4: u_5 is missing
        if (order >= 6) {
            EXPECT_NEAR(static_cast<double>(terms[6] / right[6] - 1), 2.0e-2, 0.1e-2);
        }
    }
    const auto at_order_8 = [&](const auto& figure) {
        NetworkInterpreter<Precise, kSpline.size(), 3> series(figure, 8,
                                                              spline_parameters<Precise>(cubic));
        return static_cast<double>(position_error(series.step(start, Precise(0.2)),
                                                  exact_state(cubic, 0.3, Precise(0.2))));
    };
    EXPECT_NEAR(at_order_8(printed), 1.58e-12, 0.01e-12);  // mm, in a step of 0.2 mm
    EXPECT_NEAR(at_order_8(kSpline), 8.2e-18, 0.1e-18);
}

// Propagated, the printed system is another differential equation: no order and no step helps.
TEST(SplineNetwork, WithoutTheFactorSixTheWholeCurveIsAnother) {
    struct Case {
        const char* name;
        Cubic cubic;
        double error;  // mm, largest
        double feed;   // largest phi |V| - 1
    };
    const Case cases[]{
        {"gentle", from_bezier({Vec3(0, 0, 0), Vec3(15, 0, 0), Vec3(30, 10, 0), Vec3(40, 20, 0)}),
         1.1e-3, 1.6e-4},
        {"corner", from_bezier({Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0)}),
         1.9, 0.30},
        {"hairpin", RandomCubics::hairpin(1), 8.4, 0.65}};
    for (const Case& test : cases) {
        const ArcLength table(test.cubic);
        const auto draw = [&](const auto& figure, int order, double step) {
            NetworkInterpreter<double, kSpline.size(), 3> series(
                figure, order, spline_parameters<double>(test.cubic));
            auto state = spline_state(test.cubic, 0.0);
            double worst = 0;
            double feed = 0;
            for (int n = 1; n * step < table.length(); ++n) {
                state = series.step(state, step);
                const Vec3 drawn(state[node::kX], state[node::kX + 1], state[node::kX + 2]);
                const Vec3 exact = test.cubic.position(table.parameter(n * step));
                worst = std::max(worst, (drawn - exact).norm());
                feed = std::max(
                    feed, std::abs(state[node::kPhi] * test.cubic.speed(state[node::kU]) - 1));
            }
            return std::array<double, 2>{worst, feed};
        };
        EXPECT_LT(draw(kSpline, 8, 0.025)[0], 1e-12) << test.name;
        const auto wrong = draw(without_six(), 8, 0.025);
        EXPECT_NEAR(wrong[0] / test.error, 1, 0.02) << test.name;
        EXPECT_NEAR(wrong[1] / test.feed, 1, 0.02) << test.name;
        EXPECT_NEAR(draw(without_six(), 12, 0.025)[0] / wrong[0], 1, 1e-6) << test.name;
        EXPECT_NEAR(draw(without_six(), 8, 0.0125)[0] / wrong[0], 1, 1e-2) << test.name;
    }
}

TEST(SplineNetwork, DoubleFollowsHighPrecisionToItsRoundings) {
    const Cubic cubic = gentle();
    auto fine = network<Precise>(cubic, 8);
    auto coarse = network<double>(cubic, 8);
    auto exact = spline_state(cubic, Precise(0.1));
    auto state = spline_state(cubic, 0.1);
    constexpr int kSteps = 100;
    double worst = 0;
    for (int n = 0; n < kSteps; ++n) {
        exact = fine.step(exact, Precise(0.125));
        state = coarse.step(state, 0.125);
        for (std::size_t k = 0; k < 3; ++k) {
            worst = std::max(worst, static_cast<double>(
                                        abs(exact[node::kX + k] - Precise(state[node::kX + k]))));
        }
    }
    // A step rounds a coordinate of up to 16 mm to half an ulp; phi's roundings add up in u.
    EXPECT_LT(worst, kSteps * 16 * std::ldexp(1.0, -52));
    EXPECT_GT(worst, 1e-3 * kSteps * 16 * std::ldexp(1.0, -52));
}

TEST(SplineNetwork, RenormalisingSquaresTheErrorOfPhi) {
    const Cubic cubic = gentle();
    const auto exact = spline_state(cubic, Precise(0.7));
    for (const double e : {1e-3, -1e-3, 1e-6}) {
        auto state = exact;
        for (std::size_t n = 1; n < state.size(); ++n) {
            state[n] *= 1 + Precise(e);
        }
        renormalise(cubic, state);
        const auto left = static_cast<double>(state[node::kPhi] / exact[node::kPhi] - 1);
        EXPECT_NEAR(left / (-1.5 * e * e), 1, std::abs(e)) << e;
        EXPECT_EQ(state[node::kX], exact[node::kX]);
        EXPECT_LT(abs(state[node::kQ] + pow(state[node::kPhi], 3)), Precise("1e-58"));
    }
}

// Negative control: every gain matters.
TEST(SplineNetwork, WrongGainFailsTheExactCurve) {
    const Cubic cubic = gentle();
    const auto start = spline_state(cubic, Precise(0.3));
    const auto exact = exact_state(cubic, 0.3, Precise(0.5));
    EXPECT_LT(error(network<Precise>(cubic, 24).step(start, Precise(0.5)), exact),
              Precise("1e-25"));
    for (std::size_t wrong = 0; wrong < kSpline.size(); ++wrong) {
        if (kSpline.nodes[wrong].kind == NodeKind::kSum) {
            continue;
        }
        auto mutant = kSpline;
        mutant.nodes[wrong].gain.factor *= 2;
        NetworkInterpreter<Precise, kSpline.size(), 3> series(mutant, 24,
                                                              spline_parameters<Precise>(cubic));
        EXPECT_GT(error(series.step(start, Precise(0.5)), exact), Precise("1e-7"))
            << mutant.nodes[wrong].output;
    }
}

}  // namespace curvecore::ref::spline_network_test
