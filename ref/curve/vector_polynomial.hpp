// SPDX-License-Identifier: Apache-2.0
// Products of vector polynomials, and bounds of them that hold on 0 .. 1.
#pragma once

#include <Eigen/Geometry>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// Polynomials in u, ascending powers, a column per power: vectors and numbers.
template <int Count>
using Vectors = Eigen::Matrix<double, 3, Count>;
template <int Count>
using Numbers = Eigen::Matrix<double, 1, Count>;

template <int M, int N>
Numbers<M + N - 1> dot(const Vectors<M>& a, const Vectors<N>& b) {
    Numbers<M + N - 1> sum = Numbers<M + N - 1>::Zero();
    for (int i = 0; i < M; ++i) {
        for (int j = 0; j < N; ++j) sum[i + j] += a.col(i).dot(b.col(j));
    }
    return sum;
}

template <int M, int N>
Vectors<M + N - 1> cross(const Vectors<M>& a, const Vectors<N>& b) {
    Vectors<M + N - 1> sum = Vectors<M + N - 1>::Zero();
    for (int i = 0; i < M; ++i) {
        for (int j = 0; j < N; ++j) sum.col(i + j) += a.col(i).cross(b.col(j));
    }
    return sum;
}

template <int M, int N>
Vectors<M + N - 1> scaled(const Numbers<M>& a, const Vectors<N>& b) {
    Vectors<M + N - 1> sum = Vectors<M + N - 1>::Zero();
    for (int i = 0; i < M; ++i) {
        for (int j = 0; j < N; ++j) sum.col(i + j) += a[i] * b.col(j);
    }
    return sum;
}

/// Value at u.
template <int N>
Vec3 value(const Vectors<N>& a, double u) {
    Vec3 sum = a.col(N - 1);
    for (int i = N - 2; i >= 0; --i) sum = sum * u + a.col(i);
    return sum;
}

/// Bernstein's form; on 0 .. 1 the polynomial stays in its hull.
template <int N>
Vectors<N> hull(const Vectors<N>& a) {
    Vectors<N> points = Vectors<N>::Zero();
    for (int j = 0; j < N; ++j) {
        double share = 1;  // C(j, i) / C(N-1, i)
        for (int i = 0; i <= j; ++i) {
            points.col(j) += share * a.col(i);
            share *= static_cast<double>(j - i) / (N - 1 - i);
        }
    }
    return points;
}

/// Bounds of the length and of each component on 0 .. 1.
template <int N>
double longest(const Vectors<N>& a) {
    return hull(a).colwise().norm().maxCoeff();
}

template <int N>
Vec3 widest(const Vectors<N>& a) {
    return hull(a).cwiseAbs().rowwise().maxCoeff();
}

}  // namespace curvecore::ref
