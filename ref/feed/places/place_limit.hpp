// SPDX-License-Identifier: Apache-2.0
// A limit of acceleration and jerk at a place of the path, for any motion there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace curvecore::ref {

/// One limit's view of the path at a place: r', r'', r''' of an axis, or of the path by their
/// products with each other.
///
///     |r' a + r'' q| <= A        sqrt(q) |r' a' + 3 r'' a + r''' q| <= J
struct PlaceLimit {
    double d11 = 0, d12 = 0, d13 = 0, d22 = 0, d23 = 0, d33 = 0;  // r'.r', r'.r'' ..
    double acceleration = 0;
    double jerk = 0;
};

/// Motion q, a, a' at a place: q = v^2, a = q'/2.
using PathMotion = std::array<double, 3>;

/// Product of the accelerations r' a + r'' q of two motions.
inline double acceleration_product(const PlaceLimit& l, const PathMotion& m, const PathMotion& n) {
    return (l.d11 * m[1] + l.d12 * m[0]) * n[1] + (l.d12 * m[1] + l.d22 * m[0]) * n[0];
}

/// Product of the jerks / v, r''' q + 3 r'' a + factor r' a', of two motions.
inline double jerk_product(const PlaceLimit& l, double factor, const PathMotion& m,
                           const PathMotion& n) {
    const double y = 3 * m[1];
    const double z = factor * m[2];
    return (l.d33 * m[0] + l.d23 * y + l.d13 * z) * n[0] +
           (l.d23 * m[0] + l.d22 * y + l.d12 * z) * (3 * n[1]) +
           (l.d13 * m[0] + l.d12 * y + l.d11 * z) * (factor * n[2]);
}

inline double acceleration_square(const PlaceLimit& limit, double q, double a) {
    return acceleration_product(limit, {q, a, 0}, {q, a, 0});
}

inline double jerk_square(const PlaceLimit& limit, double v, double a, double j) {
    const PathMotion m{v * v * v, v * a, j};  // a jerk / v times v
    return jerk_product(limit, 1, m, m);
}

inline double acceleration_of(const PlaceLimit& limit, double v, double a) {
    return std::sqrt(std::max(0.0, acceleration_square(limit, v * v, a)));
}

inline double jerk_of(const PlaceLimit& limit, double v, double a, double j) {
    return std::sqrt(std::max(0.0, jerk_square(limit, v, a, j)));
}

}  // namespace curvecore::ref
