// SPDX-License-Identifier: Apache-2.0
// Claims of [Tamm] about tables and pieces, measured on cams in closed form.
#pragma once

#include <algorithm>
#include <cmath>

#include "ref/cam/archimedean.hpp"
#include "ref/cam/cam_path.hpp"
#include "tb/support/programs/sample_cam.hpp"

namespace curvecore::tb {

/// The section's cubic (6) of an interval of angle, by shares of the interval.
inline ref::PolarCurve section_cubic(const std::vector<double>& rho, int m) {
    const ref::Patch patch = ref::surface_patch(kTensor, {&rho, &rho, &rho, &rho}, m, 0, 0);
    ref::PolarCurve f = ref::PolarCurve::Zero();
    f.head<4>() = patch.row(0).transpose();
    return f;
}

inline int pieces_a_turn(const std::vector<double>& rho, double delta) {
    int count = 0;
    for (int m = 0; m < static_cast<int>(rho.size()); ++m) {
        const ref::PolarCurve f = section_cubic(rho, m);
        for (double w = 0; w < 1; ++count) w = ref::longest_piece(f, w, 1, delta);
    }
    return count;
}

/// Worst errors of a section of n radii, mm: joined by Archimedean spirals, and by the cubics that
/// the paper puts between.
struct StageErrors {
    double spirals = 0;
    double cubics = 0;
};

inline StageErrors stage_errors(CamRadius radius, double x, int n) {
    constexpr int kPlaces = 32;  // in an interval of angle
    const std::vector<double> rho = cam_table(radius, n, 1, 1, x)[0].rho;
    StageErrors worst;
    for (int m = 0; m < n; ++m) {
        const ref::PolarCurve f = section_cubic(rho, m);
        for (int k = 0; k < kPlaces; ++k) {
            const double w = static_cast<double>(k) / kPlaces;
            const double exact = radius(x, 2 * M_PI * (m + w) / n);
            const double chord = ref::value(f, 0) * (1 - w) + ref::value(f, 1) * w;
            worst.spirals = std::max(worst.spirals, std::abs(chord - exact));
            worst.cubics = std::max(worst.cubics, std::abs(ref::value(f, w) - exact));
        }
    }
    return worst;
}

/// Mean length in degrees of pieces of delta on parts of a section that bend inwards and outwards;
/// 0: there are none. A piece spans sqrt(8 delta / |rho''|).
struct MeanSteps {
    double concave = 0;
    double convex = 0;
};

template <class Radius>
MeanSteps mean_steps(const Radius& radius, double delta) {
    constexpr int kPlaces = 20000;
    constexpr double kStep = 1e-3;  // rad
    double angle[2] = {}, pieces[2] = {};
    for (int i = 0; i < kPlaces; ++i) {
        const double theta = 2 * M_PI * i / kPlaces;
        const double before = radius(theta - kStep), here = radius(theta),
                     after = radius(theta + kStep);
        const double slope = (after - before) / (2 * kStep);
        const double bend = (after - 2 * here + before) / (kStep * kStep);
        const int concave = bend > here + 2 * slope * slope / here ? 1 : 0;
        angle[concave] += 360. / kPlaces;
        pieces[concave] += std::sqrt(std::abs(bend) / (8 * delta)) * 2 * M_PI / kPlaces;
    }
    const auto mean = [&](int part) { return angle[part] > 0 ? angle[part] / pieces[part] : 0; };
    return {mean(1), mean(0)};
}

/// Number of pieces a turn, all of one length, short enough for delta everywhere.
template <class Radius>
double even_pieces_a_turn(const Radius& radius, double delta) {
    constexpr int kPlaces = 20000;
    constexpr double kStep = 1e-3;  // rad
    double most = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const double theta = 2 * M_PI * i / kPlaces;
        most = std::max(
            most, std::abs(radius(theta + kStep) - 2 * radius(theta) + radius(theta - kStep)));
    }
    return 2 * M_PI * std::sqrt(most / (kStep * kStep) / (8 * delta));
}

}  // namespace curvecore::tb
