// SPDX-License-Identifier: Apache-2.0
// The bound, term by term, in the order in which hls/curves/hyperbola.hpp makes the errors.
//
// Letters: P order; y the exact h / (t0 + t) at a step's start, Y at least its word; u = half a
// last bit; C how far z + y^2 of the words may be from 0: with Anchor = 1 z is made from y, and C =
// u.
//
// Errors that a step adds to exact words y and z at its start:
//
//     e(z_i) = u + sum of A_j e(y_{i-j}) + A_{i-j} e(y_j) + e(y_j) e(y_{i-j}), j = 0 .. i
//     e(y_i) = u + e(z_{i-1}) / i + |z_{i-1}| (2 u unless i is a power of two)      y_1 = z_0
//
// with A_i, B_i at least |y_i|, |z_i|: the series of dA = (A^2 + C) dtau from A = Y. A product
// below half a last bit rounds to 0, and is wrong by no more than its size.
#include "ref/bound/hyperbola_bound.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace curvecore::ref {
namespace {

using Terms = std::array<double, 14>;

/// Errors that one step adds to y and, with Anchor = 0, to z + y^2.
struct StepErrors {
    double rounding = 0;    // error of y at the step's end, and within it
    double truncation = 0;  //
    double drift = 0;       // error of z + y^2
};

double rounded(double size, double error, double u) { return size + error < u ? size : u + error; }

StepErrors step_errors(int order, double u, double y, double c) {
    Terms a{y};  // sizes of y_i
    Terms b{};   // sizes of z_i
    Terms ey{};  // their errors
    Terms ez{};
    StepErrors step;
    double z_errors = 0;
    for (int i = 0; i <= order; ++i) {
        double products = 0;
        for (int j = 0; j <= i; ++j) {
            b[i] += a[j] * a[i - j];
            products += 2 * a[j] * ey[i - j] + ey[j] * ey[i - j];
        }
        if (i == 0) b[0] += c;
        ez[i] = i == 0 ? 0 : rounded(b[i], products, u);
        z_errors += ez[i];
        const int n = i + 1;
        a[n] = b[i] / n;
        const bool exact = (n & i) == 0;
        const double weight = exact ? 0 : 2 * u * (b[i] + ez[i]);
        ey[n] = i == 0 ? 0 : rounded(a[n], ez[i] / n + weight, u);
        if (n <= order) step.rounding += ey[n];
    }
    // The rest of the hyperbola's series alternates; what C adds to a term is at most
    // y x^i - y^(i+1).
    const double x = y + c / y;
    if (x >= 1) return {0, std::numeric_limits<double>::infinity(), 0};
    const double rest = y * std::pow(x, order + 1);
    const double of_hyperbola = std::pow(y, order + 2);
    step.truncation = of_hyperbola / (1 + y) + rest / (1 - x) - of_hyperbola / (1 - y);
    const double z_rest = rest * x * (order + 2 - (order + 1) * x) / ((1 - x) * (1 - x));
    const double y_error = step.rounding + step.truncation;
    step.drift = z_errors + z_rest + (2 * (y + c) + y_error) * y_error;
    return step;
}

}  // namespace

// From words y and z at a step's start the exact curve is y' = C - y^2. It leaves the hyperbola
// through y by at most C within the step, and two hyperbolas at y1 and y2 come nearer by
// 1 / ((1 + y1) (1 + y2)). C itself is a constant of the exact curve.
HyperbolaError hyperbola_error(const CoreParameters& format, double start, int steps) {
    if (!(start > 0 && start < 0.5)) throw std::domain_error("h / t0 must be in (0, 1/2)");
    const double u = std::ldexp(1.0, -format.coef_bits - 1);
    HyperbolaError error{0, u};
    double c = u;
    for (int n = 0;; ++n) {
        const double y = start / (1 + n * start);
        const double e = error.total();
        if (!(e < y)) return {std::numeric_limits<double>::infinity(), error.rounding};
        const StepErrors step = step_errors(format.order, u, y + e, c);
        const double nearer = n < steps ? 1 / ((1 + y) * (1 + y - e)) : 1;
        error.truncation = error.truncation * nearer + step.truncation;
        error.rounding = error.rounding * nearer + c + step.rounding;
        if (n == steps) return error;
        if (format.anchor == 0) c += step.drift;
    }
}

}  // namespace curvecore::ref
