// SPDX-License-Identifier: Apache-2.0
#include "ref/cam/cam_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 16;     // points of an integral in an interval of angle
constexpr int kBendPlaces = 4;  // points in a cell and direction at which a maximum is searched
constexpr int kRatios = 32;     // ratios Dx to Dtheta tried, 2^(1/4) apart, both ways

Eigen::RowVector4d powers(double u) { return {1, u, u * u, u * u * u}; }
Eigen::RowVector4d slopes(double u) { return {0, 1, 2 * u, 3 * u * u}; }
Eigen::RowVector4d bends(double u) { return {0, 0, 2, 6 * u}; }

double value_at(const Patch& patch, double u, double w) {
    return powers(u) * patch * powers(w).transpose();
}

}  // namespace

CamShape::CamShape(std::vector<CamSection> sections, SurfaceKind kind)
    : sections_(std::move(sections)),
      kind_(kind),
      angles_(static_cast<int>(sections_.front().rho.size())),
      pitch_(sections_[1].x - sections_[0].x) {
    std::vector<const std::vector<double>*> rows;
    for (const CamSection& section : sections_) rows.push_back(&section.rho);
    before_ = ghost_section(rows);
    after_ = ghost_section({rows.rbegin(), rows.rend()});
}

Patch CamShape::patch(int i, int m, int half_u, int half_w) const {
    const auto row = [&](int k) {
        if (k < 0) return &before_;
        if (k >= static_cast<int>(sections_.size())) return &after_;
        return &sections_[static_cast<std::size_t>(k)].rho;
    };
    return surface_patch(kind_, {row(i - 1), row(i), row(i + 1), row(i + 2)}, m, half_u, half_w);
}

CamShape::Cell CamShape::cell(double x, double degrees) const {
    const double along = (x - sections_.front().x) / pitch_;
    const int last = static_cast<int>(sections_.size()) - 2;
    const int i = std::clamp(static_cast<int>(std::floor(along)), 0, last);
    const double turn = degrees / 360 - std::floor(degrees / 360);
    const int m = std::min(static_cast<int>(turn * angles_), angles_ - 1);
    Cell found;
    found.u = along - i;
    found.w = turn * angles_ - m;
    found.patch = patch(i, m, found.u < 0.5 ? 0 : 1, found.w < 0.5 ? 0 : 1);
    return found;
}

CamShape::Place CamShape::at(double x, double degrees) const {
    const Cell c = cell(x, degrees);
    const double per_rad = angles_ / (2 * M_PI);
    const Eigen::Vector4d along_u = c.patch * powers(c.w).transpose();
    const Eigen::RowVector4d along_w = powers(c.u) * c.patch;
    Place place{};
    place.rho = powers(c.u) * along_u;
    place.by_theta = along_w.dot(slopes(c.w)) * per_rad;
    place.by_x = slopes(c.u).dot(along_u) / pitch_;
    place.bend_theta = along_w.dot(bends(c.w)) * per_rad * per_rad;
    place.bend_x = bends(c.u).dot(along_u) / (pitch_ * pitch_);
    return place;
}

double CamShape::largest_jump(int grid) const {
    double worst = 0;
    const auto compare = [&](const Patch& a, double ua, double wa, const Patch& b, double ub,
                             double wb) {
        worst = std::max(worst, std::abs(value_at(a, ua, wa) - value_at(b, ub, wb)));
    };
    const int intervals = static_cast<int>(sections_.size()) - 1;
    for (int i = 0; i < intervals; ++i) {
        for (int m = 0; m < angles_; ++m) {
            for (int half = 0; half < 2; ++half) {
                const Patch low_u = patch(i, m, 0, half), high_u = patch(i, m, 1, half);
                const Patch low_w = patch(i, m, half, 0), high_w = patch(i, m, half, 1);
                const Patch right = patch(i, (m + 1) % angles_, half, 0);
                for (int k = 0; k <= grid; ++k) {
                    const double t = half / 2. + k / (2. * grid);
                    compare(low_u, 0.5, t, high_u, 0.5, t);
                    compare(low_w, t, 0.5, high_w, t, 0.5);
                    compare(high_w, t, 1, right, t, 0);
                    if (i + 1 < intervals) compare(high_u, 1, t, patch(i + 1, m, 0, half), 0, t);
                }
            }
        }
    }
    return worst;
}

double CamShape::own_error() const {
    // The middle between neighbours at 0 and 1, of nodes -1, 0, 1, 2.
    const auto middle = [](double a, double b, double c, double d) {
        return (9 * (b + c) - (a + d)) / 16;
    };
    const int n = angles_;
    const int count = static_cast<int>(sections_.size());
    double angle = 0;
    double axis = 0;
    for (int i = 0; i < count; ++i) {
        const std::vector<double>& rho = sections_[static_cast<std::size_t>(i)].rho;
        const auto at_angle = [&](int m) { return rho[static_cast<std::size_t>((m + n) % n)]; };
        for (int m = 0; m < n && n >= 8; ++m) {
            angle = std::max(angle, std::abs(rho[static_cast<std::size_t>(m)] -
                                             middle(at_angle(m - 3), at_angle(m - 1),
                                                    at_angle(m + 1), at_angle(m + 3))));
        }
    }
    const bool by_rule = has_generatrix(kind_.surface);
    const bool linear = by_rule && kind_.generatrix == Generatrix::kLinear;
    const bool parabola = by_rule && kind_.generatrix == Generatrix::kParabola;
    for (int i = 3; i + 3 < count; ++i) {
        for (int m = 0; m < n; ++m) {
            const auto rho = [&](int k) {
                const int row = i + k;
                return sections_[static_cast<std::size_t>(row)].rho[static_cast<std::size_t>(m)];
            };
            const double estimate = linear     ? (rho(-1) + rho(1)) / 2
                                    : parabola ? (3 * rho(-1) + 6 * rho(1) - rho(3)) / 8
                                               : middle(rho(-3), rho(-1), rho(1), rho(3));
            axis = std::max(axis, std::abs(rho(0) - estimate));
        }
    }
    const int order = linear ? 4 : parabola ? 8 : 16;
    return angle / 16 + axis / order;
}

double CamShape::linear_radii(double error) const {
    std::vector<std::pair<double, double>> bends;
    const int rows = static_cast<int>(sections_.size() - 1) * kBendPlaces;
    const int columns = angles_ * kBendPlaces;
    for (int i = 0; i < rows; ++i) {
        for (int m = 0; m < columns; ++m) {
            const Place place = at(first_x() + (last_x() - first_x()) * (i + 0.5) / rows,
                                   360. * (m + 0.5) / columns);
            bends.emplace_back(place.bend_theta, place.bend_x);
        }
    }
    const double length = last_x() - first_x();
    double fewest = std::numeric_limits<double>::infinity();
    for (int k = -kRatios; k <= kRatios; ++k) {
        const double ratio = length / (2 * M_PI) * std::exp2(k / 4.);  // Dx / Dtheta
        double most = 0;                                               // 8 error / Dtheta^2
        for (const auto& [theta, x] : bends) {
            const double along = ratio * ratio * x;
            most = std::max({most, std::abs(theta), std::abs(along), std::abs(theta + along)});
        }
        const double dtheta = std::sqrt(8 * error / most);
        const double around = std::max(2 * M_PI / dtheta, 3.);
        fewest = std::min(fewest, around * std::max(length / (ratio * dtheta), 1.));
    }
    return fewest;
}

double CamShape::pieces_per_turn(double x, double delta) const {
    const int places = angles_ * kPlaces;
    double sum = 0;
    for (int k = 0; k < places; ++k) {
        sum += std::sqrt(std::abs(at(x, 360. * (k + 0.5) / places).bend_theta) / (8 * delta));
    }
    return sum * 2 * M_PI / places;
}

}  // namespace curvecore::ref
