// SPDX-License-Identifier: Apache-2.0
// Cams in closed form: the reference for tables of them.
#pragma once

#include <cmath>
#include <vector>

#include "ref/cam/cam_surface.hpp"

namespace curvecore::tb {

inline constexpr ref::SurfaceKind kTensor{ref::Surface::kLagrange, ref::Generatrix::kCubic};
inline constexpr ref::SurfaceKind kSmooth{ref::Surface::kCatmullRom, ref::Generatrix::kCubic};

inline const std::vector<ref::SurfaceKind>& all_kinds() {
    static const std::vector<ref::SurfaceKind> kinds{
        {ref::Surface::kTamm, ref::Generatrix::kLinear},
        {ref::Surface::kTamm, ref::Generatrix::kParabola},
        {ref::Surface::kTamm, ref::Generatrix::kCubic},
        {ref::Surface::kBlend, ref::Generatrix::kLinear},
        {ref::Surface::kBlend, ref::Generatrix::kParabola},
        {ref::Surface::kBlend, ref::Generatrix::kCubic},
        kTensor,
        kSmooth};
    return kinds;
}

inline double radians(double degrees) { return degrees * M_PI / 180; }

/// Radius at x (mm, 0 .. 100) and theta (rad), mm.
inline double sample_cam(double x, double theta) {
    const double u = x / 100;
    return 40 + (6 + 4 * u) * std::cos(theta + 0.6 * u) +
           (2.5 + 1.5 * std::sin(2 * M_PI * u)) * std::cos(2 * theta - 0.8 * u) +
           0.8 * (1 + u) * std::sin(3 * theta + u) + 3 * std::sin(M_PI * u);
}

/// An eccentric with three concave flanks that come and go along the axis.
inline double harmonic_cam(double x, double theta) {
    return 6 * std::cos(theta) + std::sqrt(1600 - std::pow(6 * std::sin(theta), 2)) +
           6 * (1 + 0.3 * std::sin(x / 9)) * std::cos(3 * theta - 0.5);
}

/// Two ridges that wind around the axis, a turn in 80 mm.
inline double twisted_cam(double x, double theta) {
    return 35 + 7 * std::cos(2 * (theta - 2 * M_PI * x / 80));
}

/// A base circle with one lobe of 12 mm, as valves have, that leans along the axis.
inline double lobe_cam(double x, double theta) {
    return 30 + 12 * std::exp(2.5 * (std::cos(theta - 2 - 0.01 * x) - 1));
}

/// Radius at x and theta, as the functions above.
using CamRadius = double (*)(double, double);

/// A table of `count` sections from x0, n radii each.
inline std::vector<ref::CamSection> cam_table(CamRadius radius, int n, double dx, int count,
                                              double x0 = 0) {
    std::vector<ref::CamSection> sections(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        ref::CamSection& section = sections[static_cast<std::size_t>(i)];
        section.line = i + 2;
        section.x = x0 + i * dx;
        for (int m = 0; m < n; ++m) {
            section.rho.push_back(radius(section.x, 2 * M_PI * m / n));
        }
    }
    return sections;
}

inline std::vector<ref::CamSection> sample_cam_table(int n, double dx, int count, double x0 = 0) {
    return cam_table(sample_cam, n, dx, count, x0);
}

}  // namespace curvecore::tb
