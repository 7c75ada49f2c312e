// SPDX-License-Identifier: Apache-2.0
// The exact parameter by path length along a cubic, tick after tick, in double or in 40 digits.
#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <type_traits>

#include "ref/curve/arc_length.hpp"

namespace curvecore::ref {

/// | quantity  | symbol | unit   | domain                                  |
/// |-----------|--------|--------|-----------------------------------------|
/// | path      | s      | length | from 0 on, rising from call to call     |
/// | parameter | u(s)   | 1      | 0 .. 1                                  |
///
/// Error: double 1e-13 s(1) of path; others 1e-24 s(1) per call, by Gauss quadrature from the last
/// call's point and Newton's method from the double answer.
template <class Real>
class ExactPath {
  public:
    explicit ExactPath(const Cubic& cubic) : cubic_(cubic), table_(cubic) {}

    double length() const { return table_.length(); }

    Real parameter(const Real& s) {
        const double guess = table_.parameter(static_cast<double>(s));
        if constexpr (std::is_floating_point_v<Real>) {
            return guess;
        } else {
            // Newton's method runs twice: the first correction is of 1e-13, the second of its
            // square.
            for (const Real& target : {Real(guess), Real(0)}) {
                const Real next = target > 0 ? target : Real(u_ + (s - s_) / speed(u_));
                s_ += integral(u_, next, rule(u_, next), 40);
                u_ = next;
            }
            u_ += (s - s_) / speed(u_);
            s_ = s;
            return u_;
        }
    }

  private:
    Real speed(const Real& u) const {
        using std::sqrt;
        Real square(0);
        for (int k = 0; k < 3; ++k) {
            const Real v = (3 * Real(cubic_.a[k]) * u + 2 * Real(cubic_.b[k])) * u + cubic_.c[k];
            square += v * v;
        }
        return sqrt(square);
    }

    Real rule(const Real& from, const Real& to) const {
        return boost::math::quadrature::gauss<Real, 20>::integrate(
            [this](const Real& u) { return speed(u); }, from, to);
    }

    Real integral(const Real& from, const Real& to, const Real& whole, int depth) const {
        using std::abs;
        const Real middle = (from + to) / 2;
        const Real first = rule(from, middle);
        const Real second = rule(middle, to);
        if (depth == 0 || abs(first + second - whole) <= Real(1e-24) * table_.length()) {
            return first + second;
        }
        return integral(from, middle, first, depth - 1) + integral(middle, to, second, depth - 1);
    }

    Cubic cubic_;
    ArcLength table_;
    Real u_{0};
    Real s_{0};
};

}  // namespace curvecore::ref
