// SPDX-License-Identifier: Apache-2.0
// Seeded cubics that bring the words of the spline kernel to the ends of their ranges.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "ref/curve/arc_length.hpp"
#include "ref/curve/cubic.hpp"

namespace curvecore::tb {

/// | extreme      | what comes to its limit                                                   |
/// |--------------|---------------------------------------------------------------------------|
/// | kSlowest     | phi: the speed has its minimum, half the largest, where a step ends       |
/// | kFastest     | V, V.V and m: the speed has its maximum there                             |
/// | kBend        | b + 3 a v: 2 at the end, a few last bits less                             |
/// | kCubicTerm   | 3 a: 2                                                                    |
/// | kAny         | control points at random, as large as the words' precision allows         |
enum class Extreme { kSlowest, kFastest, kBend, kCubicTerm, kAny, kCount };

class ExtremeCubics {
  public:
    /// Creates the generator. `room`: margin that the planner keeps between |V| and 1; `hair`: a
    /// few last bits of a word.
    ExtremeCubics(std::uint64_t seed, double room, double hair)
        : random_(seed), scale_(1 + room + hair), hair_(hair) {}

    /// A cubic whose largest speed per unit of u is about `size` units.
    ref::Cubic next(Extreme extreme, double size) {
        switch (extreme) {
            case Extreme::kSlowest:
                return slowest(size);
            case Extreme::kFastest:
                return fastest(size);
            case Extreme::kBend:
                return bend(size, false);
            case Extreme::kCubicTerm:
                return bend(size, true);
            default:
                return any(size);
        }
    }

    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random_);
    }

  private:
    /// Integrates dr/du = size (v0 + v1 u + v2 u^2) along each axis.
    static ref::Cubic integral(double size, const ref::Vec3& v0, const ref::Vec3& v1,
                               const ref::Vec3& v2) {
        return {size * v2 / 3, size * v1 / 2, size * v0, ref::Vec3::Zero()};
    }

    ref::Cubic turned(const ref::Cubic& cubic) {
        const Eigen::Quaterniond turn =
            random_() % 2 == 0 ? Eigen::Quaterniond::UnitRandom() : Eigen::Quaterniond::Identity();
        return {turn * cubic.a, turn * cubic.b, turn * cubic.c, cubic.d};
    }

    /// Size for which `path` of a cubic of size 1 is a whole number of steps, of any length.
    double whole_steps(double path, double size) {
        const double step = std::exp2(std::floor(std::log2(size * path) - uniform(0, 4)));
        return std::max(1.0, std::round(size * path / step)) * step / path;
    }

    ref::Cubic slowest(double size) {
        const double r = 0.5 * scale_ + hair_ * uniform(0, 4);
        const double u0 = uniform(0.5, 0.95);
        const double q = (1 - r) / (u0 * u0);
        const double path = r * u0 + q * u0 * u0 * u0 / 3;
        const ref::Vec3 x = ref::Vec3::UnitX();
        return turned(
            integral(whole_steps(path, size), x * (r + q * u0 * u0), -2 * q * u0 * x, q * x));
    }

    ref::Cubic fastest(double size) {
        const double u0 = uniform(0.5, 0.95);
        const double q = uniform(0, 0.48) / (u0 * u0);
        const double path = u0 - q * u0 * u0 * u0 / 3;
        const ref::Vec3 x = ref::Vec3::UnitX();
        return turned(
            integral(whole_steps(path, size), x * (1 - q * u0 * u0), 2 * q * u0 * x, -q * x));
    }

    /// A cubic with V_x from x0 to x1, a slope at the end, and V_y = y; the size puts b + 3 a beta,
    /// or 3 a, at 2.
    struct Bend {
        double y, x1, slope, x0;

        double a() const { return slope - (x1 - x0); }
        double b() const { return slope - 2 * a(); }
        bool within() const {  // |V| <= 1
            const double middle = a() > 0 ? std::clamp(-b() / (2 * a()), 0.0, 1.0) : 0;
            return std::abs(x0 + (b() + a() * middle) * middle) <= x1;
        }
        ref::Cubic cubic(double size) const {
            return integral(size, {x0, y, 0}, {b(), 0, 0}, {a(), 0, 0});
        }
    };

    ref::Cubic bend(double size, bool cubic_term) {
        const double unit = std::exp2(std::round(std::log2(size)));
        while (true) {
            Bend bend{uniform(0.501, 0.75), 0, uniform(2, 4), 0};
            bend.x1 = std::sqrt(1 - bend.y * bend.y);
            bend.x0 = uniform(-bend.x1, 0);
            if (!bend.within()) continue;
            // beta = size scale / 2^lambda: b + 3 a beta = slope / (2 scale beta), and
            // 3 a = a / (scale beta^2).
            const double most = (2 - hair_ * uniform(1, 3)) * scale_;
            const double by_slope = bend.slope / (2 * most);
            const double by_term = std::sqrt(std::max(0.0, bend.a()) / most);
            const double beta = cubic_term ? by_term : by_slope;
            if (beta < std::max({0.5, by_slope, by_term}) || beta >= 1) continue;
            const double scaled = beta * unit / scale_;
            if (!cubic_term && !align(bend, scaled)) continue;
            return turned(bend.cubic(scaled));
        }
    }

    /// Moves x0, which changes neither the end's V nor its slope, until the last step begins a part
    /// of a unit before the end: there v's drift is largest and b + 3 a v nearest to 2.
    bool align(Bend& bend, double size) {
        const auto length = [&](double x0) {
            Bend moved = bend;
            moved.x0 = x0;
            return ref::arc_length(moved.cubic(size), 0, 1);
        };
        double low = bend.x0, high = bend.x0 + 0.1;
        const double least = std::min(length(low), length(high));
        const double most = std::max(length(low), length(high));
        const double step = std::exp2(std::floor(std::log2(most - least)) - 1);
        const double wanted = std::ceil(least / step) * step + std::exp2(uniform(-14, -4));
        if (wanted > most || high > bend.x1) return false;
        const bool rises = length(high) > length(low);
        for (int n = 0; n < 60; ++n) {
            const double middle = (low + high) / 2;
            ((length(middle) < wanted) == rises ? low : high) = middle;
        }
        bend.x0 = low;
        return bend.within();
    }

    ref::Cubic any(double size) {
        ref::Bezier points;
        for (ref::Vec3& point : points) {
            point = size * ref::Vec3(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5));
        }
        return ref::from_bezier(points);
    }

    std::mt19937_64 random_;
    double scale_, hair_;
};

}  // namespace curvecore::tb
