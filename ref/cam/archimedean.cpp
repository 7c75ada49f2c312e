// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/archimedean.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/Polynomials>
#include <vector>

namespace curvecore::ref {
namespace {

constexpr double kTaken = 1 + 1e-9;  // share of delta: the closed form's own rounding
constexpr double kUsed = 0.9;        // share of delta that a piece, where one is searched, uses
constexpr int kTries = 40;

/// Real roots of sum of c[i] w^i; leading zeros are dropped.
template <int Count>
std::vector<double> real_roots(const Eigen::Matrix<double, Count, 1>& c) {
    const double scale = c.cwiseAbs().maxCoeff();
    int degree = Count - 1;
    while (degree > 0 && std::abs(c[degree]) <= 1e-13 * scale) --degree;
    std::vector<double> roots;
    if (degree == 0) return roots;
    if (degree == 1) return {-c[0] / c[1]};
    if (degree == 2) {
        const double half = -c[1] / 2;
        const double square = half * half - c[0] * c[2];
        if (square < 0) return roots;
        const double sum = half + std::copysign(std::sqrt(square), half);
        if (sum == 0) return {0};
        return {sum / c[2], c[0] / sum};
    }
    Eigen::PolynomialSolver<double, Eigen::Dynamic> solver(Eigen::VectorXd(c.head(degree + 1)));
    solver.realRoots(roots, 1e-7);
    return roots;
}

PolarCurve about(const PolarCurve& f, double w0) {
    PolarCurve g = f;  // Taylor shift by repeated synthetic division
    for (int i = 0; i < 6; ++i) {
        for (int j = 5; j >= i; --j) g[j] += w0 * g[j + 1];
    }
    return g;
}

/// Ends of all pieces from w0 of the cubic a b c d whose greatest deviation somewhere is delta.
std::vector<double> ends_of_cubic(const PolarCurve& f, double w0, double delta) {
    const double a = f[3], b = f[2], c = f[1], d = f[0];
    const double rho0 = ((a * w0 + b) * w0 + c) * w0 + d;
    std::vector<double> ends;
    for (const double signed_delta : {delta, -delta}) {
        const double A = 2 * a;
        const double B = b - 3 * a * w0;
        const double C = -2 * b * w0;
        const double D = rho0 + signed_delta - d - c * w0;
        for (const double w : real_roots<4>({D, C, B, A})) {  // (12)
            if (w <= w0) continue;
            const double k = 3 * a * w * w + 2 * b * w + c;  // (10)
            // (13) and (14) meet at w0 as well: that root is divided out.
            for (const double w1 : real_roots<3>({c - k + b * w0 + a * w0 * w0, b + a * w0, a})) {
                if (w1 > w0) ends.push_back(w1);
            }
        }
    }
    return ends;
}

/// Shortens a piece until it keeps delta; `far` is its first guess.
double drawn_in(const PolarCurve& f, double w0, double far, double end, double delta) {
    double kept = w0;
    double over = end;  // not known to be too far while it is `end`
    double w1 = std::min(far, end);
    for (int i = 0; i < kTries; ++i) {
        const double deviation = chord_deviation(f, w0, w1);
        if (deviation <= delta) {
            kept = w1;
            if (w1 == end || deviation >= kUsed * delta) return kept;
        } else {
            over = w1;
        }
        // A chord's deviation grows with the square of its length.
        const double aim = std::sqrt((1 + kUsed) / 2 * delta / std::max(deviation, 1e-3 * delta));
        w1 = w0 + (w1 - w0) * std::min(aim, 2.0);
        if (w1 <= kept || (w1 >= over && over < end)) w1 = (kept + over) / 2;
        w1 = std::min(w1, end);
    }
    return kept;
}

}  // namespace

double value(const PolarCurve& f, double w) {
    double sum = f[6];
    for (int i = 5; i >= 0; --i) sum = sum * w + f[i];
    return sum;
}

double chord_deviation(const PolarCurve& f, double w0, double w1) {
    const double length = w1 - w0;
    if (!(length > 0)) return 0;
    PolarCurve h = about(f, w0);  // h(t), t = (w - w0) / length, zero at 0 and 1
    double power = 1;
    for (int i = 0; i <= 6; ++i, power *= length) h[i] *= power;
    h[1] = -h.tail<5>().sum();
    h[0] = 0;
    Eigen::Matrix<double, 6, 1> slope;
    for (int i = 1; i <= 6; ++i) slope[i - 1] = i * h[i];
    double worst = 0;
    for (const double t : real_roots<6>(slope)) {
        if (t > 0 && t < 1) worst = std::max(worst, std::abs(value(h, t)));
    }
    return worst;
}

double longest_piece(const PolarCurve& f, double w0, double end, double delta) {
    const bool cubic = f.tail<3>().isZero(0);
    PolarCurve near = f;
    double shift = 0;
    if (!cubic) {
        near = about(f, w0);
        near.tail<3>().setZero();
        shift = w0;
    }
    double best = w0;
    bool straight = true;
    for (const double local : ends_of_cubic(near, w0 - shift, delta)) {
        straight = false;
        const double w1 = std::min(local + shift, end);
        if (w1 > best && cubic && chord_deviation(f, w0, w1) <= kTaken * delta) best = w1;
        if (!cubic) best = std::max(best, w1);
    }
    if (straight || (cubic && best == w0)) best = end;
    return drawn_in(f, w0, best, end, delta * kTaken);
}

}  // namespace curvecore::ref
