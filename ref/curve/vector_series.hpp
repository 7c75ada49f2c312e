// SPDX-License-Identifier: Apache-2.0
// A vector as a power series from a place on: joints of a machine, and the tool that they carry.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "ref/curve/vec3.hpp"

namespace curvecore::ref {

/// r(s) = c0 + c1 s + .. to order `Orders`: a column each.
template <int Orders>
struct VectorSeries {
    static constexpr int kOrders = Orders;

    Eigen::Matrix<double, 3, Orders + 1> c = Eigen::Matrix<double, 3, Orders + 1>::Zero();

    /// d^n r / ds^n at s.
    Vec3 derivative(double s, int n) const {
        Vec3 sum = Vec3::Zero();
        for (int i = Orders; i >= n; --i) sum = sum * s + falling(i, n) * c.col(i);
        return sum;
    }
    Vec3 at(double s) const { return derivative(s, 0); }

    /// Upper bound of each component of the n-th derivative from 0 to s.
    Vec3 most(double s, int n) const {
        Vec3 sum = Vec3::Zero();
        for (int i = Orders; i >= n; --i) sum = sum * s + falling(i, n) * c.col(i).cwiseAbs();
        return sum;
    }

    /// The same vector from the place s on.
    VectorSeries shifted(double s) const {
        VectorSeries from;
        double factorial = 1;
        for (int n = 0; n <= Orders; ++n) {
            if (n > 1) factorial *= n;
            from.c.col(n) = derivative(s, n) / factorial;
        }
        return from;
    }

    /// The same vector by x = factor s.
    VectorSeries stretched(double factor) const {
        VectorSeries by = *this;
        for (int n = 0; n <= Orders; ++n) by.c.col(n) /= std::pow(factor, n);
        return by;
    }

  private:
    static double falling(int i, int n) {
        double product = 1;
        for (int k = 0; k < n; ++k) product *= i - k;
        return product;
    }
};

}  // namespace curvecore::ref
