// SPDX-License-Identifier: Apache-2.0
#include "ref/numeric/simpson.hpp"

#include <cmath>

namespace curvecore::ref {
namespace {

constexpr int kMostIntervals = 1 << 20;

}  // namespace

double simpson(const Cubic& cubic, double u0, double u1, int n) {
    const double h = (u1 - u0) / n;
    double odd = 0;
    double even = 0;
    for (int i = 1; i < n; ++i) (i % 2 == 1 ? odd : even) += cubic.speed(u0 + i * h);
    return h / 3 * (cubic.speed(u0) + 4 * odd + 2 * even + cubic.speed(u1));
}

SimpsonLength simpson_runge(const Cubic& cubic, double u0, double u1, double tolerance, int first) {
    double coarse = simpson(cubic, u0, u1, first);
    for (int n = 2 * first;; n *= 2) {
        const double fine = simpson(cubic, u0, u1, n);
        const double runge = (fine - coarse) / 15;
        if (std::abs(runge) < tolerance || n >= kMostIntervals) {
            return {fine + runge, std::abs(runge), n};
        }
        coarse = fine;
    }
}

}  // namespace curvecore::ref
