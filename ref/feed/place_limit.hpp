// SPDX-License-Identifier: Apache-2.0
// A limit of acceleration and jerk at a place of the path, whatever the motion there.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace curvecore::ref {

/// What one limit sees of the path at a place: r', r'', r''' of an axis, or of the path by their
/// products with each other.
///
///     |r' a + r'' q| <= A        sqrt(q) |r' a' + 3 r'' a + r''' q| <= J
struct PlaceLimit {
    double d11 = 0, d12 = 0, d13 = 0, d22 = 0, d23 = 0, d33 = 0;  // r'.r', r'.r'' ..
    double acceleration = 0;
    double jerk = 0;
};

/// |r' a + r'' q|^2, q = v^2
inline double acceleration_square(const PlaceLimit& l, double q, double a) {
    return l.d11 * a * a + 2 * l.d12 * a * q + l.d22 * q * q;
}

/// |r' y + r'' x|^2 = m^T (this) m with m = (x, y, z): (q, a, a')
inline Eigen::Matrix3d acceleration_form(const PlaceLimit& l) {
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
    s.topLeftCorner<2, 2>() << l.d22, l.d12, l.d12, l.d11;
    return s;
}

/// |r''' x + 3 r'' y + factor r' z|^2 = m^T (this) m with m = (x, y, z): jerk for (v^3, v a, j),
/// jerk / v for (q, a, a')
inline Eigen::Matrix3d jerk_square(const PlaceLimit& l, double factor = 1) {
    const double d13 = factor * l.d13;
    const double d12 = 3 * factor * l.d12;
    Eigen::Matrix3d s;
    s << l.d33, 3 * l.d23, d13, 3 * l.d23, 9 * l.d22, d12, d13, d12, factor * factor * l.d11;
    return s;
}

inline double acceleration_of(const PlaceLimit& limit, double v, double a) {
    return std::sqrt(std::max(0.0, acceleration_square(limit, v * v, a)));
}

inline double jerk_of(const PlaceLimit& limit, double v, double a, double j) {
    const Eigen::Vector3d m(v * v * v, v * a, j);
    return std::sqrt(std::max(0.0, m.dot(jerk_square(limit) * m)));
}

}  // namespace curvecore::ref
