// SPDX-License-Identifier: Apache-2.0
// The hyperbola's network against its closed form, and the effect of an inconsistent start value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ref/series/figures.hpp"
#include "ref/series/interpreter.hpp"
#include "tb/support/judge/precise_cubic.hpp"

namespace curvecore::ref::hyperbola_network_test {

using tb::Precise;

// Largest relative error of y over t = 0 .. 20 in 200 steps, k = t0 = 1.
template <class Real>
double worst_error(int order) {
    auto network = interpret<Real>(kHyperbola, order, {Real(1)});
    std::array<Real, 2> state{Real(1), Real(-1)};
    Real worst(0);
    for (int n = 1; n <= 200; ++n) {
        state = network.step(state, Real(1) / 10);
        const Real relative = state[0] * (1 + Real(n) / 10) - 1;
        worst = std::max(worst, Real(relative < 0 ? -relative : relative));
    }
    return static_cast<double>(worst);
}

TEST(HyperbolaNetwork, ErrorFallsWithTheOrder) {
    struct Row {
        int order;
        double expected;
        double tolerance;
    };
    for (const Row& row : {Row{1, 2.9, 0.05}, Row{2, 1.07, 0.005}, Row{4, 1.2e-2, 0.05e-2},
                           Row{8, 1.7e-6, 0.05e-6}, Row{12, 2.2e-10, 0.05e-10}}) {
        EXPECT_NEAR(worst_error<Precise>(row.order), row.expected, row.tolerance) << row.order;
        EXPECT_NEAR(worst_error<double>(row.order), row.expected, row.tolerance) << row.order;
    }
    EXPECT_LT(worst_error<Precise>(52), 1e-40);
}

// The network draws y' = C - k y^2 if z + k y^2 = C is not 0: a small C of either sign ends the
// hyperbola.
TEST(HyperbolaNetwork, InconsistentStartIsNeverPulledBack) {
    auto network = interpret<double>(kHyperbola, 8, {1.0});
    constexpr double kC = 1e-6;
    std::array<double, 2> high{1, -1 + kC};
    std::array<double, 2> low{1, -1 - kC};
    std::array<double, 2> cured{1, -1 + kC};
    double crossing = 0;
    double h = 0;
    for (double t = 0; t < 4000; t += h) {
        h = std::min({0.05 * (1 + t), 1.0, 4000 - t});
        high = network.step(high, h);
        cured = network.step(cured, h);
        cured[1] = -cured[0] * cured[0];
        if (crossing == 0) {
            low = network.step(low, h);
            crossing = low[0] < 0 ? t + h : 0;
        }
    }
    EXPECT_NEAR(high[0], std::sqrt(kC), 0.001 * std::sqrt(kC)) << "it sticks at sqrt(C / k)";
    // y = sqrt(C) cot(sqrt(C) t + ..) falls through 0 after a quarter of its period.
    EXPECT_NEAR(crossing, std::atan(1 / std::sqrt(kC)) / std::sqrt(kC), 1);
    EXPECT_NEAR(cured[0] * 4001, 1, 1e-6) << "z recomputed from y at every step";
}

}  // namespace curvecore::ref::hyperbola_network_test
