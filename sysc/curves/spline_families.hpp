// SPDX-License-Identifier: Apache-2.0
// Seeded cubics of every shape and size that a spline core must draw, in length units of 1 nm.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "ref/curve/cubic.hpp"

namespace curvecore::sysc {

enum class SplineShape { kRandom, kHairpin, kSBend, kInflexion, kNearCusp, kStraight };

/// size: extent of the curve in units; for hairpins the least radius of curvature.
struct SplineFamily {
    std::string name;
    SplineShape shape;
    double size;
};

inline const std::vector<SplineFamily>& spline_families() {
    static const std::vector<SplineFamily> families = {
        {"random cubics, 20 um", SplineShape::kRandom, 20e3},
        {"random cubics, 200 um", SplineShape::kRandom, 200e3},
        {"random cubics, 2 mm", SplineShape::kRandom, 2e6},
        {"random cubics, 20 mm", SplineShape::kRandom, 20e6},
        {"random cubics, 200 mm", SplineShape::kRandom, 200e6},
        {"random cubics, 1 m", SplineShape::kRandom, 1e9},
        {"hairpins, r = 3 um", SplineShape::kHairpin, 3e3},
        {"hairpins, r = 100 um", SplineShape::kHairpin, 100e3},
        {"hairpins, r = 1 mm", SplineShape::kHairpin, 1e6},
        {"S bends, 100 um .. 100 mm", SplineShape::kSBend, 0},
        {"inflexions, 100 um .. 100 mm", SplineShape::kInflexion, 0},
        {"near cusps, 100 um .. 20 mm", SplineShape::kNearCusp, 0},
        {"straight lines, 1 um .. 1 m", SplineShape::kStraight, 0},
    };
    return families;
}

class SplineMaker {
  public:
    explicit SplineMaker(std::uint64_t seed) : random_(seed) {}

    ref::Cubic next(const SplineFamily& family) {
        const ref::Vec3 x = direction();
        const ref::Vec3 y = x.cross(direction()).normalized();
        const ref::Vec3 z = x.cross(y);
        ref::Bezier p;
        double extent = family.size;
        switch (family.shape) {
            case SplineShape::kRandom:
                for (ref::Vec3& point : p) point = extent * cube();
                break;
            case SplineShape::kHairpin: {
                // A parabola x = c t, y = e t^2 with its vertex inside, radius c^2 / (2 e).
                extent = std::min(family.size * 3000, 20e6);
                const double e = 4 * extent;
                const double c = std::sqrt(2 * e * family.size);
                const double t0 = uniform(-0.6, -0.4);
                ref::Cubic parabola;
                parabola.b = e * y;
                parabola.c = c * x + 2 * t0 * e * y;
                parabola.d = c * t0 * x + e * t0 * t0 * y;
                return parabola;
            }
            case SplineShape::kSBend:
                extent = std::pow(10, uniform(5, 8));
                p = {0 * x, extent * x, extent * (uniform(-0.3, 0.3) * x + y),
                     extent * (uniform(0.8, 1.2) * x + y)};
                break;
            case SplineShape::kInflexion:
                extent = std::pow(10, uniform(5, 8));
                p = {0 * x, extent * (x / 3 + uniform(0.1, 0.5) * y),
                     extent * (2 * x / 3 - uniform(0.1, 0.5) * y + uniform(-0.2, 0.2) * z),
                     extent * x};
                break;
            case SplineShape::kNearCusp:
                extent = std::pow(10, uniform(5, std::log10(20e6)));
                p = {0 * x, extent * (x + y), extent * (uniform(0.01, 0.2) * x + y), extent * x};
                break;
            case SplineShape::kStraight: {
                extent = std::pow(10, uniform(3, 9));
                const double lead = random_() % 2 == 0 ? 1.0 / 3 : uniform(0.2, 0.4);
                p = {0 * x, lead * extent * x, (1 - lead) * extent * x, extent * x};
                break;
            }
        }
        const ref::Vec3 place = 4e8 * cube();
        for (ref::Vec3& point : p) point += place;
        return ref::from_bezier(p);
    }

    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random_);
    }

  private:
    ref::Vec3 cube() { return {uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5)}; }
    ref::Vec3 direction() {
        ref::Vec3 point = cube();
        while (point.norm() < 0.1 || point.norm() > 0.5) point = cube();
        return point.normalized();
    }

    std::mt19937_64 random_;
};

}  // namespace curvecore::sysc
