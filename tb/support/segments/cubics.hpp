// SPDX-License-Identifier: Apache-2.0
// Cubics for tests: random ones of every kind, and ones that are hard to follow.
#pragma once

#include <cmath>
#include <random>

#include "ref/curve/cubic.hpp"

namespace curvecore::tb {

class RandomCubics {
  public:
    explicit RandomCubics(unsigned seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(engine_);
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    ref::Vec3 vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

    /// A cubic of four control points in a cube.
    ref::Cubic bezier() { return ref::from_bezier({vector(), vector(), vector(), vector()}); }

    /// A cubic with V = A (u - u0)^2 + B (u - u0) + E: slow near u0 if E is small, with a cusp if E
    /// is 0.
    ref::Cubic slow_at(double u0, double slowness) {
        const ref::Vec3 a = vector();
        const ref::Vec3 b = vector();
        const ref::Vec3 e = vector() * slowness;
        return {a / 3, b / 2 - a * u0, (a * u0 - b) * u0 + e, vector()};
    }

    /// A straight line with a varying speed that may turn back.
    ref::Cubic straight() {
        const ref::Vec3 along = vector();
        return {along * uniform(-1, 1), along * uniform(-1, 1), along * uniform(-1, 1), vector()};
    }

    /// A cubic of any kind, chosen by `n`.
    ref::Cubic any(int n) {
        switch (n % 5) {
            case 0:
                return slow_at(uniform(0, 1), log_uniform(1e-10, 1));
            case 1:
                return slow_at(uniform(0, 1), 0);
            case 2:
                return straight();
            case 3:
                return hairpin(log_uniform(1e-6, 1));
            default:
                return bezier();
        }
    }

    /// The cubic that [Chikurov]'s scheme loses: a parabola (c t, 80 t^2), t = u - 1/2, of radius r
    /// at its vertex.
    static ref::Cubic hairpin(double r) {
        const double c = std::sqrt(160 * r);
        return {{0, 0, 0}, {0, 80, 0}, {c, -80, 0}, {-c / 2, 20, 0}};
    }

  private:
    std::mt19937 engine_;
};

}  // namespace curvecore::tb
