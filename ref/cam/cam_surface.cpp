// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/cam_surface.hpp"

namespace curvecore::ref {
namespace {

using Row4 = Eigen::RowVector4d;

/// Columns: ascending powers; rows: the nodes -1, 0, 1, 2.
Patch lagrange_weights() {
    Patch weights;
    weights << 0, -1. / 3, 1. / 2, -1. / 6,  //
        1, -1. / 2, -1, 1. / 2,              //
        0, 1, 1. / 2, -1. / 2,               //
        0, -1. / 6, 0, 1. / 6;
    return weights;
}

Patch catmull_rom_weights() {
    Patch weights;
    weights << 0, -1. / 2, 1, -1. / 2,  //
        1, 0, -5. / 2, 3. / 2,          //
        0, 1. / 2, 2, -3. / 2,          //
        0, 0, -1. / 2, 1. / 2;
    return weights;
}

/// Radii m - 1 .. m + 2 of the four sections, a row per section.
Patch radii(const SectionWindow& window, int m) {
    Patch rho;
    for (int row = 0; row < 4; ++row) {
        const std::vector<double>& section = *window[static_cast<std::size_t>(row)];
        const int n = static_cast<int>(section.size());
        for (int k = 0; k < 4; ++k) {
            rho(row, k) = section[static_cast<std::size_t>((m + k - 1 + n) % n)];
        }
    }
    return rho;
}

/// The polynomial p(u - 1), p(0) = 0, in powers of u.
Row4 from_the_next(const Row4& p) {
    return {-p[1] + p[2] - p[3], p[1] - 2 * p[2] + 3 * p[3], p[2] - 3 * p[3], p[3]};
}

/// Rise of a generatrix from its radius in the nearest section, in powers of u, given the radii of
/// sections i - 1 .. i + 2.
Row4 generatrix_rise(Generatrix kind, const Eigen::Vector4d& rho, int half_u) {
    const double before = rho[half_u];
    const double here = rho[half_u + 1];
    const double after = rho[half_u == 0 ? 2 : 3];
    Row4 rise = Row4::Zero();
    switch (kind) {
        case Generatrix::kLinear:  // (3)
            rise[1] = rho[2] - rho[1];
            break;
        case Generatrix::kParabola:  // (5): A u^2 + B u
            rise[2] = (before - 2 * here + after) / 2;
            rise[1] = (after - before) / 2;
            break;
        case Generatrix::kCubic:
            rise = rho.transpose() * lagrange_weights();
            rise[0] = 0;
            return rise;
    }
    return half_u == 0 ? rise : from_the_next(rise);
}

/// The patch of tamm and blend.
Patch by_generatrices(SurfaceKind kind, const Patch& rho, int half_u, int half_w) {
    // A cubic's own interval is the middle one, so it switches at the sections.
    const int half = kind.generatrix == Generatrix::kCubic ? 0 : half_u;
    Patch patch = Patch::Zero();
    patch.row(0) = rho.row(half + 1) * lagrange_weights();  // (6)
    const auto rise = [&](int k) { return generatrix_rise(kind.generatrix, rho.col(k), half); };
    if (kind.surface == Surface::kTamm) {
        patch.col(0) += rise(half_w + 1).transpose();
    } else {
        Patch rises;
        for (int k = 0; k < 4; ++k) rises.col(k) = rise(k).transpose();
        patch += rises * lagrange_weights();
    }
    return patch;
}

}  // namespace

Patch surface_patch(SurfaceKind kind, const SectionWindow& window, int m, int half_u, int half_w) {
    const Patch rho = radii(window, m);
    if (has_generatrix(kind.surface)) return by_generatrices(kind, rho, half_u, half_w);
    const Patch weights =
        kind.surface == Surface::kLagrange ? lagrange_weights() : catmull_rom_weights();
    return weights.transpose() * rho * weights;
}

std::vector<double> ghost_section(const std::vector<const std::vector<double>*>& sections) {
    const std::size_t known = std::min<std::size_t>(sections.size(), 4);
    static constexpr double kWeights[3][4] = {{2, -1}, {3, -3, 1}, {4, -6, 4, -1}};
    std::vector<double> ghost(sections[0]->size(), 0.0);
    for (std::size_t i = 0; i < known; ++i) {
        for (std::size_t m = 0; m < ghost.size(); ++m) {
            ghost[m] += kWeights[known - 2][i] * (*sections[i])[m];
        }
    }
    return ghost;
}

}  // namespace curvecore::ref
