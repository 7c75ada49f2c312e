// SPDX-License-Identifier: Apache-2.0
// The bounds, term by term, in the order in which hls/curves/arc.hpp makes the errors.
//
// Letters: W coefficient width, P order, G guard bits; h = 2^k units per step; theta = h phi, the
// angle of a step; x = length / h, steps in the segment; m = ceil(x) - 1, steps completed before
// the last; half = 2^-(W-1), half a last bit of a coefficient; fine = 2^-W, half a last bit of a
// weight; g = 2^-(G+1), half a last bit of a position.
#include "ref/bound/error_bound.hpp"

#include <algorithm>
#include <cmath>

#include "ref/bound/spline_bound.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

/// Steps, angle of a step and sizes of the last bits of one segment, or the worst of a family's.
struct Steps {
    double h, theta, x, m;
    double half, fine, g;
    bool exact_shift;  // to positions
    bool family;

    Steps(const CoreParameters& format, int step_exponent, double turn_per_unit, double length,
          bool of_family)
        : h(std::ldexp(1.0, step_exponent)),
          theta(h * turn_per_unit),
          x(length / h),
          m(std::max(0.0, std::ceil(x) - 1)),
          half(std::ldexp(1.0, 1 - format.coef_bits)),
          fine(std::ldexp(1.0, -format.coef_bits)),
          g(std::ldexp(1.0, -format.guard_bits - 1)),
          exact_shift(step_exponent >= format.coef_bits - 2 - format.guard_bits),
          family(of_family) {}

    Steps(const CoreParameters& format, const Segment& segment)
        : Steps(format, segment.step_exponent, segment.arc().twist(),
                static_cast<double>(segment.length) * kQuantum, false) {}
};

/// Displacement, in units of h, after u steps of a unit error in t and in n at the start:
/// (sin u theta + 1 - cos u theta) / theta. A family's is that of the worst angle up to u theta: it
/// grows to 1.3081 u at 1.17 rad and falls from there.
double drift(const Steps& s, double u) {
    const double theta = s.theta;
    const double angle = u * theta;
    if (angle < 1e-4) return u * (1 + angle / 2);
    if (s.family && angle > 1.1) return 1.3083 * u;
    const double half_sine = std::sin(angle / 2);
    return (std::sin(angle) + 2 * half_sine * half_sine) / theta;
}

/// Sum of drift(x - j), j = 1..m. The drift grows with u up to a quarter turn, so beyond 32 steps
/// the integral over (0, x) of u + theta u^2 / 2 >= drift covers the sum.
double drift_sum(const Steps& s) {
    if (s.m > 32) return s.x * s.x * (0.5 + s.x * s.theta / 6);
    double sum = 0;
    for (int j = 1; j <= static_cast<int>(s.m); ++j) sum += drift(s, s.x - j);
    return sum;
}

/// Roundings of one step, given exact t and n.
///
///   N_i = rshift(w_i T_{i-1}), w_i = rshift(theta Recip_i);  |N_i|, |T_i| <= theta^(i-1) / i!
///   e_i = half + |T_{i-1}| (fine + theta fine [Recip_i inexact]) + (theta / i) e_{i-1},  e_1 = 0
///
/// unless the product is below half a last bit: then the word is 0 and wrong by |N_i|.
struct Roundings {
    double coefficients = 0;  // sum of e_i: error of the sum of N_i, or of the series at tau <= 1
    int words = 1;            // N_1 .. N_words may differ from 0
};

Roundings step_roundings(const CoreParameters& format, const Steps& s) {
    Roundings all;
    double error = 0;
    double before = 1;  // theta^(i-2) / (i-1)!
    for (int i = 2; i <= format.order; ++i) {
        const bool exact = (i & (i - 1)) == 0;
        const double size = before * s.theta / i;
        const double product = before * s.fine * (1 + (exact ? 0 : s.theta)) + s.theta / i * error;
        const bool vanishes = size + product < s.half;
        error = vanishes ? size : s.half + product;
        if (!vanishes) all.words = i;
        all.coefficients += error;
        before = size;
    }
    return all;
}

/// One axis of the circular part: the errors of state, coefficients, Horner and angle, without the
/// positions' own roundings.
double circular_error(const CoreParameters& format, const Steps& s) {
    const Roundings step = step_roundings(format, s);
    const double coefficients = step.coefficients;
    // Start words t, n: half a last bit each.
    double error = s.h * drift(s, s.x) * s.half;
    // theta: an angle error of fine per step, displacement h integral of u fine du.
    error += s.h * s.fine * s.x * s.x / 2;
    // Each completed step leaves sum(e_i) in the position and half + theta sum(e_i) in t and n.
    error += s.m * s.h * coefficients;
    error += s.h * drift_sum(s) * (s.half + s.theta * coefficients);
    // The sample: the same coefficients at tau <= 1, and a Horner stage for each that is not 0.
    if (!format.polynomial()) {
        return error + s.h * (coefficients + step.words * s.half);
    }
    // Two scalar series of the angle in q = tau^2 (the same coefficients, (P-1)/2 stages each and
    // one product by q), two products by unit vectors, one by tau; q itself is rounded, which
    // d(sine)/dq <= theta^2 / 6 and the versine <= theta / 2 scale down.
    const int order = step.words;
    const int stages = (order - 1) / 2 + (order % 2 == 0 ? order - 2 : order - 3) / 2 + 1;
    return error + s.h * (coefficients + (stages + 3) * s.half + s.theta * s.fine);
}

/// One axis of the advance: the word's half a last bit over the whole length, and the last product.
double advance_error(const Steps& s, double advance, double half) {
    const double word = advance / (2 * half);
    const bool exact = word == std::round(word);
    return exact ? 0 : s.h * s.x * half;
}

/// Start word, one rounding per completed step and one in the sample, unless the shift loses
/// nothing.
double position_error(const Steps& s) { return s.g + (s.exact_shift ? 0 : (s.m + 1) * s.g); }

/// tau has W-1 bits: a cut of whole quanta below h 2^-(W-1); and the length is the difference of
/// two rounded path lengths.
double path_shift(const Steps& s) { return std::max(0.0, s.h * s.half - kQuantum) + kQuantum; }

double truncation(const CoreParameters& format, const Steps& s, double radius) {
    double at_one = 1;  // 1 / (P+1)!
    for (int i = 2; i <= format.order + 1; ++i) at_one /= i;
    const double step = at_one * std::pow(s.theta, format.order + 1);
    const double rest = step * std::pow(s.x - s.m, format.order + 1);
    const double growth = std::exp(s.m * step);  // |T_P| <= 1 + step
    // Radius of the ellipse that one axis sees is at most the circle's.
    return radius * (s.m * step + rest) * growth;
}

}  // namespace

// The network applies T_P(i theta), the series cut after the power P, instead of exp(i theta); they
// differ by at most theta^(P+1) / (P+1)!. The position is R / cos(pitch) times what n has turned,
// so m steps and a fraction f differ from the circle by R (m d(theta) + d(f theta)) |T_P|^m.
double truncation_bound(const CoreParameters& format, const Segment& segment) {
    const double radius = segment.arc().radius;
    return radius > 0 ? truncation(format, Steps(format, segment), radius) : 0;
}

double rounding_bound(const CoreParameters& format, const Segment& segment) {
    const Steps s(format, segment);
    const ArcPiece& arc = segment.arc();
    const double circular = arc.radius > 0 ? circular_error(format, s) : 0;
    double along = 0;  // worst axis: circular part and advance
    for (int axis = 0; axis < 3; ++axis) {
        const bool turns = std::hypot(arc.tangent[axis], arc.normal[axis]) * arc.radius > 0;
        const double error = (turns ? circular : 0) + advance_error(s, arc.advance[axis], s.half);
        along = std::max(along, error);
    }
    // The product advance * tau of a line or an auxiliary axis; an arc's Horner has counted it.
    if (arc.radius <= 0) along += s.h * s.half;
    // X Y Z are at most as fast as the path, an auxiliary axis may be faster.
    const double shift = path_shift(s);
    for (const double advance : segment.aux_advance) {
        const double faster = std::max(0.0, std::abs(advance) - 1);
        along = std::max(along, advance_error(s, advance, s.half) + s.h * s.half + faster * shift);
    }
    return along + position_error(s) + shift;
}

double segment_bound(const CoreParameters& format, const Segment& segment) {
    if (segment.kind() == CurveKind::kSpline) return spline_error(format, segment).total();
    if (segment.kind() == CurveKind::kTable) return segment.bound;  // ref/segment/table_segment.hpp
    return truncation_bound(format, segment) + rounding_bound(format, segment);
}

// Term by term, each grows with the length and with theta <= h / least_radius, also the
// coefficients' roundings: an e_i is largest at the largest theta, since a word that vanishes there
// vanishes at any smaller one and its size grows with theta. Truncation takes that theta with
// most_radius, though no segment has both. A line's errors, advance, last product and positions,
// are among a helix's.
double family_bound(const CoreParameters& format, const ArcFamily& family) {
    const Steps s(format, family.step_exponent, 1 / family.least_radius, family.length, true);
    return truncation(format, s, family.most_radius) + circular_error(format, s) +
           s.h * s.x * s.half + position_error(s) + path_shift(s);
}

}  // namespace curvecore::ref
