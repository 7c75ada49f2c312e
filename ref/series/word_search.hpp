// SPDX-License-Identifier: Apache-2.0
// [Obukhov]'s search in words: its cost in hardware, beside the sixteen integrators.
#pragma once

#include <algorithm>
#include <cmath>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// Every result is rounded to `fraction` bits of a cubic that is scaled to |V| < 1. A length is one
/// panel of Simpson's rule; a speed is the root of a sum of squares by a table and three of
/// Newton's steps for 1 / |V|, which the division of dt shares.
///
/// | products per                | count                                                          |
/// |-----------------------------|----------------------------------------------------------------|
/// | speed                       | 6 (V by Horner) + 3 (squares) + 3 x 3 + 1 (Newton, |V|) = 19 |
/// | iteration                   | 2 speeds + 1 (h / 6) + 1 (dt) = 40                             |
/// | sample                      | its iterations + 9 (position by Horner)                        |
class WordSearch {
  public:
    static constexpr int kSpeedProducts = 19;
    static constexpr int kIterationProducts = 2 * kSpeedProducts + 2;
    static constexpr int kPositionProducts = 9;
    static constexpr int kMostIterations = 20;

    WordSearch(const Cubic& cubic, int fraction, double tolerance)
        : quantum_(std::ldexp(1.0, -fraction)) {
        double fastest = 0;
        for (int i = 0; i <= kPlaces; ++i) {
            fastest = std::max(fastest, cubic.speed(static_cast<double>(i) / kPlaces));
        }
        scale_ = std::exp2(std::ceil(std::log2(fastest * kRoom)));
        for (int axis = 0; axis < 3; ++axis) {
            a_[axis] = word(3 * cubic.a[axis] / scale_);
            b_[axis] = word(2 * cubic.b[axis] / scale_);
            c_[axis] = word(cubic.c[axis] / scale_);
        }
        tolerance_ = tolerance / scale_;
    }

    /// Returns the parameter at a length of `s` mm from the start.
    double at(double s) {
        const double wanted = word(s / scale_);
        double err = wanted - s_;
        int iterations = 0;
        while (std::abs(err) >= tolerance_ && iterations < kMostIterations) {
            const double from = speed(t_);
            const double next = std::clamp(word(t_ + word(err / from)), 0.0, 1.0);
            const double middle = speed(word((t_ + next) / 2));
            s_ = word(s_ + word((next - t_) / 6 * (from + 4 * middle + speed(next))));
            t_ = next;
            err = wanted - s_;
            ++iterations;
        }
        iterations_ += iterations;
        ++samples_;
        return t_;
    }

    double products_per_sample() const {
        return kPositionProducts + kIterationProducts * static_cast<double>(iterations_) /
                                       static_cast<double>(samples_);
    }

  private:
    static constexpr int kPlaces = 1000;
    static constexpr double kRoom = 1.01;

    double word(double x) const { return std::rint(x / quantum_) * quantum_; }

    double speed(double u) const {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double v = word(word(a_[axis] * u + b_[axis]) * u + c_[axis]);
            sum += v * v;
        }
        return std::max(word(std::sqrt(word(sum))), quantum_);
    }

    double quantum_;
    double scale_;  // mm
    double a_[3], b_[3], c_[3];
    double tolerance_;
    double t_ = 0;
    double s_ = 0;
    long iterations_ = 0;
    long samples_ = 0;
};

}  // namespace curvecore::ref
