// SPDX-License-Identifier: Apache-2.0
// The true radius of convergence of u(s) on a cubic: the reference for step limits.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::tb {

/// rho(u0) = |integral of sqrt(V.V) du| from u0 to the zero of V.V that the straight ray in the
/// s plane meets first. Source: u - u* ~ (s - s*)^(2/3) there.
class ConvergenceRadius {
  public:
    using Complex = std::complex<double>;

    explicit ConvergenceRadius(const ref::Cubic& cubic) : cubic_(cubic) {
        const ref::Vec3 a = 3 * cubic.a;
        const ref::Vec3 b = 2 * cubic.b;
        const ref::Vec3& c = cubic.c;
        // Coefficients of V.V from the constant term up; negligible leading terms are left out.
        std::vector<double> p{c.squaredNorm(), 2 * b.dot(c), b.squaredNorm() + 2 * a.dot(c),
                              2 * a.dot(b), a.squaredNorm()};
        while (p.size() > 1 && p.back() <= 1e-26 * *std::max_element(p.begin(), p.end())) {
            p.pop_back();
        }
        const auto degree = static_cast<Eigen::Index>(p.size() - 1);
        if (degree == 0) {
            return;
        }
        Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
        for (Eigen::Index i = 0; i < degree; ++i) {
            companion(i, degree - 1) = -p[static_cast<std::size_t>(i)] / p.back();
            if (i > 0) {
                companion(i, i - 1) = 1;
            }
        }
        const auto roots = companion.eigenvalues().eval();
        zeros_.assign(roots.data(), roots.data() + degree);
    }

    /// Returns the radius at u0; infinite if no zero is met.
    double operator()(double u0) const {
        double radius = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < zeros_.size(); ++i) {
            const Complex end = path_to(u0, i);
            if (std::abs(end) < radius && nearest(follow(u0, 0.98 * end)) == i) {
                radius = std::abs(end);
            }
        }
        return radius;
    }

  private:
    // Path along the straight line from u0 to zero i. About u0, V.V is |V|^2 times the product of
    // 1 - (u - u0) / (u* - u0), and no factor leaves the principal branch on a straight line. With
    // u = u* - (u* - u0) x^2 the root's own factor is x^2.
    Complex path_to(double u0, std::size_t i) const {
        const Complex way = zeros_[i] - u0;
        const auto integrand = [&](double x) {
            Complex product(2 * x * x);
            for (std::size_t j = 0; j < zeros_.size(); ++j) {
                if (j != i) {
                    product *= std::sqrt(1.0 - (1 - x * x) * way / (zeros_[j] - u0));
                }
            }
            return product;
        };
        return cubic_.speed(u0) * way *
               boost::math::quadrature::gauss<double, 30>::integrate(integrand, 0.0, 1.0);
    }

    // Follows the straight ray of the s plane to its end and returns u: Runge-Kutta on
    // du/ds = 1 / sqrt(V.V), the branch kept by continuity.
    Complex follow(double u0, Complex s) const {
        constexpr int kSteps = 60;
        Complex u(u0);
        Complex root(cubic_.speed(u0));
        const auto rate = [&](Complex at) {
            Complex square(0);
            for (int k = 0; k < 3; ++k) {
                const Complex v = (3 * cubic_.a[k] * at + 2 * cubic_.b[k]) * at + cubic_.c[k];
                square += v * v;
            }
            const Complex next = std::sqrt(square);
            root = std::real(next * std::conj(root)) < 0 ? -next : next;
            return 1.0 / root;
        };
        for (int n = 0; n < kSteps; ++n) {
            const Complex h = s / double(kSteps);
            const Complex k1 = rate(u);
            const Complex k2 = rate(u + h / 2.0 * k1);
            const Complex k3 = rate(u + h / 2.0 * k2);
            const Complex k4 = rate(u + h * k3);
            u += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
        return u;
    }

    std::size_t nearest(Complex u) const {
        const auto closer = [&](Complex a, Complex b) { return std::abs(a - u) < std::abs(b - u); };
        return static_cast<std::size_t>(std::min_element(zeros_.begin(), zeros_.end(), closer) -
                                        zeros_.begin());
    }

    ref::Cubic cubic_;
    std::vector<Complex> zeros_;
};

}  // namespace curvecore::tb
