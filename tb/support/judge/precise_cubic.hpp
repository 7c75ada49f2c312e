// SPDX-License-Identifier: Apache-2.0
// A cubic in 60 decimal digits: the reference for the double functions and the networks.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::tb {

namespace mp = boost::multiprecision;
using Precise = mp::number<mp::cpp_bin_float<60>, mp::et_off>;
using PreciseVector = Eigen::Matrix<Precise, 3, 1>;

struct PreciseCubic {
    PreciseVector a, b, c, d;

    explicit PreciseCubic(const ref::Cubic& cubic)
        : a(cubic.a.cast<Precise>()),
          b(cubic.b.cast<Precise>()),
          c(cubic.c.cast<Precise>()),
          d(cubic.d.cast<Precise>()) {}

    PreciseVector position(const Precise& u) const { return ((a * u + b) * u + c) * u + d; }
    PreciseVector velocity(const Precise& u) const { return (a * (3 * u) + b * 2) * u + c; }
    PreciseVector acceleration(const Precise& u) const { return a * (6 * u) + b * 2; }
    Precise speed(const Precise& u) const { return velocity(u).norm(); }
    PreciseVector tangent(const Precise& u) const { return velocity(u) / speed(u); }

    /// Path length from u0 to u1, adaptive; `split` are points where the speed is not smooth or
    /// nearly so.
    Precise length(const Precise& u0, const Precise& u1, const Precise& tolerance,
                   std::vector<Precise> split = {}) const {
        std::vector<Precise> ends{u0};
        for (const Precise& u : split) {
            if (u > u0 && u < u1) {
                ends.push_back(u);
            }
        }
        ends.push_back(u1);
        std::sort(ends.begin(), ends.end());
        Precise sum(0);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            sum += panel(ends[i], ends[i + 1], rule(ends[i], ends[i + 1]), tolerance, 60);
        }
        return sum;
    }

    /// Inverse of the length: u(s) from u0 on, by Newton's method from `guess`.
    Precise parameter(const Precise& u0, const Precise& s, Precise guess,
                      const Precise& tolerance) const {
        Precise path = length(u0, guess, tolerance);
        for (int n = 0; n < 20; ++n) {
            const Precise step = (s - path) / speed(guess);
            const Precise next = guess + step;
            if (abs(step) * speed(guess) <= tolerance) {
                return next;
            }
            path += step > 0 ? length(guess, next, tolerance) : -length(next, guess, tolerance);
            guess = next;
        }
        return guess;
    }

  private:
    Precise rule(const Precise& u0, const Precise& u1) const {
        return boost::math::quadrature::gauss<Precise, 30>::integrate(
            [this](const Precise& u) { return speed(u); }, u0, u1);
    }

    Precise panel(const Precise& u0, const Precise& u1, const Precise& whole,
                  const Precise& tolerance, int depth) const {
        const Precise middle = (u0 + u1) / 2;
        const Precise first = rule(u0, middle);
        const Precise second = rule(middle, u1);
        if (depth == 0 || abs(first + second - whole) <= tolerance) {
            return first + second;
        }
        return panel(u0, middle, first, tolerance, depth - 1) +
               panel(middle, u1, second, tolerance, depth - 1);
    }
};

}  // namespace curvecore::tb
