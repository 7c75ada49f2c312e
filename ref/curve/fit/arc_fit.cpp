// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/arc_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ref/curve/arc_length.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

constexpr double kFewestPoints = 8;
constexpr double kMostPoints = 1000;  // points at which a biarc is compared with the cubic

/// Bounds of a cubic's derivatives, from its control points.
struct Derivatives {
    double least_speed = 0;  // along its end speed; <= 0: unknown
    double acceleration = 0;
};

Derivatives derivatives(const Cubic& cubic) {
    const Bezier points = to_bezier(cubic);
    const Vec3 chord = (points[3] - points[0]).stableNormalized();
    Derivatives found{3 * (points[1] - points[0]).dot(chord), 0};
    for (int i = 1; i < 3; ++i) {
        const Vec3 out = points[i + 1] - points[i];
        const Vec3 in = points[i] - points[i - 1];
        found.least_speed = std::min(found.least_speed, 3 * out.dot(chord));
        found.acceleration = std::max(found.acceleration, 6 * (out - in).norm());
    }
    return found;
}

using Biarc = std::array<TangentArc, 2>;

class ArcFitter {
  public:
    ArcFitter(const Cubic& cubic, double tolerance)
        : cubic_(cubic), length_(cubic), tolerance_(tolerance) {}

    ArcFit run() {
        double step = 1;
        for (double u = 0; u < 1;) {
            step = std::min(step, 1 - u);
            // The rest behind a step must be no sliver.
            if (u + step < 1 && u + 2 * step > 1) step = (1 - u) / 2;
            const double end = u + step < 1 ? u + step : 1;
            const double error = append(u, end);
            // The distance grows with the cube of the step, as long as the curve bends alike.
            const double growth = error > 0 ? std::cbrt(tolerance_ / error) : 2;
            if (error > tolerance_) {
                step *= std::clamp(0.95 * growth, 0.1, 0.9);
                continue;
            }
            fit_.deviation = std::max(fit_.deviation, error);
            u = end;
            step *= std::clamp(0.95 * growth, 0.5, 2.0);
        }
        return std::move(fit_);
    }

  private:
    /// Appends the piece u0 .. u1 if it is within the tolerance; returns its error.
    double append(double u0, double u1) {
        const double s0 = length_.path(u0);
        const double length = length_.path(u1) - s0;
        const Vec3 start = cubic_.position(u0);
        const Vec3 end = cubic_.position(u1);
        const Derivatives bounds = derivatives(sub_cubic(cubic_, u0, u1));
        if (bounds.least_speed > 0) {
            const std::optional<Biarc> arcs =
                biarc(start, tangent(cubic_, u0), end, tangent(cubic_, u1));
            const double error = arcs ? distance(*arcs, bounds, s0, length) : kUnlimited;
            if (error <= tolerance_) {
                if ((*arcs)[0].angle == 0 && (*arcs)[1].angle == 0) {
                    fit_.arcs.push_back(straight(start, end));
                } else {
                    fit_.arcs.insert(fit_.arcs.end(), arcs->begin(), arcs->end());
                }
                return error;
            }
            if (length > tolerance_) return error;
        } else if (length > tolerance_) {
            return kUnlimited;
        }
        if (start != end) fit_.arcs.push_back(straight(start, end));
        return length / 2;
    }

    double distance(const Biarc& arcs, const Derivatives& bounds, double s0, double length) const {
        const double of_arcs = arcs[0].length() + arcs[1].length();
        const double bend = std::max(arcs[0].curvature(), arcs[1].curvature());
        const double second =
            length * length * bounds.acceleration / (bounds.least_speed * bounds.least_speed) +
            of_arcs * of_arcs * bend;
        // The number of points at which the error between them is an eighth of the tolerance.
        const double n = std::max(kFewestPoints, std::ceil(std::sqrt(second / tolerance_)));
        if (!(n <= kMostPoints)) return kUnlimited;
        const double between = second / (8 * n * n);
        double worst = 0;
        for (double i = 1; i < n; ++i) {
            const double s = of_arcs * i / n;
            const double first = arcs[0].length();
            const Vec3 there = s < first ? arcs[0].at(s) : arcs[1].at(s - first);
            const Vec3 here = cubic_.position(length_.parameter(s0 + length * i / n));
            worst = std::max(worst, (there - here).norm());
        }
        return worst + between;
    }

    const Cubic& cubic_;
    ArcLength length_;
    double tolerance_;
    ArcFit fit_;
};

}  // namespace

ArcFit fit_arcs(const Cubic& cubic, double tolerance) { return ArcFitter(cubic, tolerance).run(); }

std::vector<double> fit_chords(const Cubic& cubic, double tolerance) {
    std::vector<double> u{0};
    double step = 1;
    while (u.back() < 1) {
        step = std::min(step, 1 - u.back());
        const double end = u.back() + step < 1 ? u.back() + step : 1;
        const double error = derivatives(sub_cubic(cubic, u.back(), end)).acceleration / 8;
        const double growth = error > 0 ? std::sqrt(tolerance / error) : 2;
        if (error > tolerance) {
            step *= std::clamp(0.98 * growth, 0.1, 0.95);
            continue;
        }
        u.push_back(end);
        step *= std::clamp(0.98 * growth, 1.0, 2.0);
    }
    return u;
}

}  // namespace curvecore::ref
