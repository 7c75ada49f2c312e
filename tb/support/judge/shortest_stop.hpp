// SPDX-License-Identifier: Apache-2.0
// The shortest stop along a line, a circle or a helix, by another method: in the plane of speed and
// acceleration, as such a path is alike everywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ref/machine/machine.hpp"

namespace curvecore::tb {

/// The path has |r''| and |r'''|; r' r''' = -|r''|^2, r'' r''' = 0. With speed v, acceleration a
/// and jerk u along it
///
///     a^2 + k^2 v^4 <= A^2       (u - k^2 v^3)^2 + 9 k^2 v^2 a^2 + (t^2 - k^4) v^6 <= J^2
///
/// The quickest way to rest is the least u until the largest u just ends in rest, at most as far as
/// A allows.
class ShortestStop {
  public:
    ShortestStop(const ref::Machine& machine, double bend, double third)
        : a_(machine.acceleration), j_(machine.jerk), k2_(bend * bend), t2_(third * third) {
        double v = 0;
        double a = 0;
        // Integration backwards from rest.
        for (int i = 0; a > -most(v); ++i) {
            ends_.push_back({v, a, i * kStep});
            const double u = room(v, a) + k2_ * v * v * v;
            v -= a * kStep - u * kStep * kStep / 2;
            a -= u * kStep;
        }
    }

    double time(double v, double a) const {
        for (double time = 0;; time += kStep) {
            const auto end =
                std::lower_bound(ends_.begin(), ends_.end(), v,
                                 [](const End& e, double speed) { return e.v < speed; });
            if (end != ends_.end() && a <= end->a) return time + end->time;
            if (v <= 0 || time > 10) return time;
            v += a * kStep;
            a = std::max(a + (k2_ * v * v * v - room(v, a)) * kStep, -most(v));
        }
    }

  private:
    static constexpr double kStep = 2e-6;  // s

    struct End {
        double v, a, time;
    };

    double most(double v) const { return std::sqrt(std::max(0., a_ * a_ - k2_ * v * v * v * v)); }
    double room(double v, double a) const {
        const double x = v * v * v;
        return std::sqrt(
            std::max(0., j_ * j_ - 9 * k2_ * v * v * a * a - (t2_ - k2_ * k2_) * x * x));
    }

    double a_, j_, k2_, t2_;
    std::vector<End> ends_;
};

}  // namespace curvecore::tb
