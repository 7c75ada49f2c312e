// SPDX-License-Identifier: Apache-2.0
// Surfaces through a cam's radii, [Tamm]: bicubic in each cell of the table.
//
//     rho(x, theta),   u = (x - x_i) / Dx,   w = (theta - theta_m) / Dtheta,   0 <= u, w <= 1
//
// | surface     | rho                                                          | jumps            |
// |-------------|--------------------------------------------------------------|------------------|
// | tamm        | f_i(w) + g_m(u): the cubic (6) of the nearest section, and   | at the mid-lines |
// |             | what the nearest generatrix, (3) or (5), adds from there     |                  |
// | blend       | f_i(w), and the g of four generatrices with f_i's weights    | between sections |
// | lagrange    | cubics through four neighbours both ways                     | C0               |
// | catmull-rom | cubics with the neighbours' slopes both ways                 | C1               |
//
// f_i goes through four neighbouring radii and is used on the middle interval. A generatrix is
// linear (3), a parabola through three sections (5), both from the nearest section, or a cubic
// through four sections.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "ref/cam/cam_table.hpp"

namespace curvecore::ref {

enum class Generatrix { kLinear, kParabola, kCubic };
enum class Surface { kTamm, kBlend, kLagrange, kCatmullRom };
constexpr std::array<std::string_view, 3> kGeneratrixNames{"linear", "parabola", "cubic"};
constexpr std::array<std::string_view, 4> kSurfaceNames{"tamm", "blend", "lagrange", "catmull-rom"};

/// Returns true for the surfaces that are made of generatrices.
constexpr bool has_generatrix(Surface surface) {
    return surface == Surface::kTamm || surface == Surface::kBlend;
}

struct SurfaceKind {
    Surface surface = Surface::kLagrange;
    Generatrix generatrix = Generatrix::kCubic;
};

/// Radii of sections i - 1 .. i + 2, none of them null.
using SectionWindow = std::array<const std::vector<double>*, 4>;

/// rho = sum of p(j, k) u^j w^k.
using Patch = Eigen::Matrix4d;

/// The patch of angle interval m, on the given half of it and of the section interval; 0 is the
/// lower.
Patch surface_patch(SurfaceKind kind, const SectionWindow& window, int m, int half_u, int half_w);

/// The section before the first: the cubic through the first four sections continued (with three
/// sections a parabola, with two a line); in reverse order the section after the last.
std::vector<double> ghost_section(const std::vector<const std::vector<double>*>& sections);

}  // namespace curvecore::ref
