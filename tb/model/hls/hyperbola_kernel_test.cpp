// SPDX-License-Identifier: Apache-2.0
// The hyperbola's words against its closed form: within the derived bound, which is never idle, and
// within their ranges; with Anchor 0 they leave the curve, as [Chikurov]'s network does.
#define CURVECORE_CHECKED
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hls/curves/hyperbola.hpp"
#include "ref/bound/hyperbola_bound.hpp"

namespace curvecore::tb::hyperbola_kernel_test {

template <int Order, int CoefBits, bool Anchor>
using Format = hls::Configuration<Order, CoefBits, 32, 10, 0, hls::SamplerMode::kSeries, Anchor>;

template <class C>
ref::CoreParameters parameters_of() {
    ref::CoreParameters parameters;
    parameters.order = C::kOrder;
    parameters.coef_bits = C::kCoefBits;
    parameters.anchor = C::kAnchor ? 1 : 0;
    return parameters;
}

/// A run from the word of h / t0.
template <class C>
class Course {
  public:
    explicit Course(double start) : start_(start) {
        kernel_.load(std::llround(std::ldexp(start, C::kCoefBits)));
    }
    void step() {
        kernel_.step();
        ++steps_;
    }
    /// Exact value of h / (t0 + t) now.
    double exact(double tau = 0) const { return start_ / (1 + (steps_ + tau) * start_); }
    double y() const { return value(kernel_.y_[0]); }
    double error(double tau) const {
        double sum = 0;
        for (int i = C::kOrder; i >= 0; --i) sum = sum * tau + value(kernel_.y_[i]);
        return sum - exact(tau);
    }
    double bound() const {
        return ref::hyperbola_error(parameters_of<C>(), start_, steps_).total();
    }

  private:
    static double value(const typename C::Coef& word) {
        return std::ldexp(static_cast<double>(hls::to_int(word)), -C::kCoefBits);
    }
    double start_;
    int steps_ = 0;
    hls::HyperbolaNetwork<C> kernel_;
};

/// Worst error within a step, relative to its bound, over random courses; checked after 0, 1, 2, 4,
/// .. steps, as long as there is a bound.
template <class C>
double worst_part(double low, double high, int courses, int steps) {
    std::mt19937_64 random(7);
    double worst = 0;
    for (int n = 0; n < courses; ++n) {
        Course<C> course(std::uniform_real_distribution<double>(low, high)(random));
        for (int step = 0, next = 0; step <= steps; ++step) {
            if (step > 0) course.step();
            if (step < next) continue;
            next = std::max(1, 2 * step);
            const double bound = course.bound();
            if (!(bound < course.exact())) break;
            for (const double tau : {0.0, 0.37, 1.0}) {
                worst = std::max(worst, std::abs(course.error(tau)) / bound);
            }
        }
    }
    return worst;
}

/// Figures of short courses from starts in an octave: where rounding rules and where truncation
/// does.
template <class C>
void expect_bound_kept_and_not_idle() {
    double least = 1;
    for (int b = 2; b <= 10; ++b) {
        const double high = std::ldexp(1.0, 1 - b);
        const double part = worst_part<C>(high / 2, high, 2000, 4);
        EXPECT_LE(part, 1) << "h / t0 up to 2^" << 1 - b;
        least = std::min(least, part);
    }
    EXPECT_GT(least, 1.0 / 3) << "the bound is idle";
    EXPECT_LE((worst_part<C>(1e-3, 0.49, 100, 2000)), 1);
}

TEST(HyperbolaKernel, KeepsItsBoundWhichIsNotIdle) {
    expect_bound_kept_and_not_idle<Format<2, 18, true>>();
    expect_bound_kept_and_not_idle<Format<3, 24, true>>();
    expect_bound_kept_and_not_idle<Format<4, 30, true>>();
    expect_bound_kept_and_not_idle<Format<6, 36, true>>();
    expect_bound_kept_and_not_idle<Format<7, 29, true>>();
    expect_bound_kept_and_not_idle<Format<12, 36, true>>();
}

TEST(HyperbolaKernel, KeepsItsBoundWithBothVariablesCarried) {
    expect_bound_kept_and_not_idle<Format<2, 18, false>>();
    expect_bound_kept_and_not_idle<Format<6, 36, false>>();
    expect_bound_kept_and_not_idle<Format<12, 33, false>>();
}

TEST(HyperbolaKernel, HoldsTheLargestStart) {
    for (const double start : {0.5 - std::ldexp(1.0, -36), 0.49, std::ldexp(1.0, -36), 1e-5}) {
        Course<Format<12, 36, true>> run(start);
        for (int n = 0; n < 1000; ++n) run.step();
        EXPECT_LE(std::abs(run.error(1)), run.bound()) << start;
    }
    EXPECT_THROW((Course<Format<6, 36, true>>(0.5)), std::range_error) << "no such word";
    const ref::CoreParameters parameters = parameters_of<Format<6, 36, true>>();
    EXPECT_THROW(ref::hyperbola_error(parameters, 0.5, 0), std::domain_error);
    EXPECT_THROW(ref::hyperbola_error(parameters, 0, 0), std::domain_error);
}

// [Chikurov]'s network draws y' = C - k y^2 once rounding has made C = z + k y^2. In words C is
// negative, for the last changes of z round to 0, and y falls through 0. Words of 24 bits, t = 0 ..
// 100 t0 and more.
TEST(HyperbolaKernel, OfAnchorZeroLeavesTheHyperbolaAndOfAnchorOneDoesNot) {
    constexpr int kSteps = 2000;
    int fallen = 0;
    double worst = 0;
    for (int n = 0; n < 20; ++n) {
        const double start = 0.05 + 0.002 * n;
        Course<Format<6, 24, true>> anchored(start);
        Course<Format<6, 24, false>> carried(start);
        for (int i = 0; i < kSteps; ++i) anchored.step();
        for (int i = 0; i < kSteps && carried.y() > 0; ++i) carried.step();
        fallen += carried.y() <= 0 ? 1 : 0;
        worst = std::max(worst, std::abs(anchored.error(0)) / anchored.exact());
        EXPECT_LE(std::abs(anchored.error(0)), anchored.bound());
    }
    EXPECT_EQ(fallen, 20);
    EXPECT_LT(worst, 0.002);
}

}  // namespace curvecore::tb::hyperbola_kernel_test
