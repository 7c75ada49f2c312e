// SPDX-License-Identifier: Apache-2.0
// A cam's surface by its definition (ref/cam/cam_surface.hpp), from radii, one place at a time: the
// reference for the program's polynomials in each cell.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ref/cam/cam_surface.hpp"

namespace curvecore::tb {

class PlainSurface {
  public:
    PlainSurface(std::vector<ref::CamSection> sections, ref::SurfaceKind kind)
        : sections_(std::move(sections)),
          kind_(kind),
          n_(static_cast<int>(sections_.front().rho.size())),
          dx_(sections_[1].x - sections_[0].x) {}

    struct Place {
        double rho, by_degree, by_x;  // mm; slopes in the place's own cell
    };

    /// Place on the surface; x in mm, any number of turns.
    Place at(double x, double degrees) const {
        const double along = (x - sections_.front().x) / dx_;
        const double last = static_cast<double>(sections_.size()) - 2;
        const double i = std::clamp(std::floor(along), 0., last);
        const double turn = degrees / 360 - std::floor(degrees / 360);
        const double m = std::min(std::floor(turn * n_), n_ - 1.);
        Cell cell;
        cell.i = static_cast<int>(i);
        cell.m = static_cast<int>(m);
        const double u = along - i, w = turn * n_ - m;
        cell.upper_u = u >= 0.5;
        cell.upper_w = w >= 0.5;
        constexpr double kStep = 1e-5;
        const auto slope = [&](double du, double dw) {
            return (rho(cell, u + du, w + dw) - rho(cell, u - du, w - dw)) / (2 * kStep);
        };
        return {rho(cell, u, w), slope(0, kStep) * n_ / 360, slope(kStep, 0) / dx_};
    }

  private:
    struct Cell {
        int i, m;               // the section and the generatrix before it
        bool upper_u, upper_w;  // nearer to the next ones
    };

    /// Lagrange's basis: 1 at node k, 0 at the others.
    template <std::size_t Count>
    static double basis(const std::array<double, Count>& nodes, std::size_t k, double t) {
        double product = 1;
        for (std::size_t j = 0; j < Count; ++j) {
            if (j != k) product *= (t - nodes[j]) / (nodes[k] - nodes[j]);
        }
        return product;
    }
    template <std::size_t Count, class Value>
    static double through(const std::array<double, Count>& nodes, double t, const Value& value) {
        double sum = 0;
        for (std::size_t k = 0; k < Count; ++k) {
            sum += basis(nodes, k, t) * value(static_cast<int>(nodes[k]));
        }
        return sum;
    }
    template <class Value>
    static double cubic(double t, const Value& value) {
        return through<4>({-1, 0, 1, 2}, t, value);
    }
    template <class Value>
    static double catmull_rom(double t, const Value& value) {
        const double m0 = (value(1) - value(-1)) / 2, m1 = (value(2) - value(0)) / 2;
        return value(0) * (1 - t) * (1 - t) * (1 + 2 * t) + value(1) * t * t * (3 - 2 * t) +
               m0 * t * (1 - t) * (1 - t) - m1 * t * t * (1 - t);
    }

    /// Radius m of section i; beyond the ends on the cubic through the last four (three, two).
    double radius(int i, int m) const {
        const int count = static_cast<int>(sections_.size());
        const auto known = [&](int row) {
            return sections_[static_cast<std::size_t>(row)]
                .rho[static_cast<std::size_t>((m % n_ + n_) % n_)];
        };
        if (i >= 0 && i < count) return known(i);
        const auto near = [&](int k) { return known(i < 0 ? k : count - 1 - k); };
        if (count == 2) return through<2>({0, 1}, -1, near);
        if (count == 3) return through<3>({0, 1, 2}, -1, near);
        return through<4>({0, 1, 2, 3}, -1, near);
    }

    /// Contribution of generatrix m to the radius of section s; u is counted from section i.
    double rise(int i, int s, int m, double u) const {
        const auto rho = [&](int k) { return radius(s + k, m); };
        const double v = u - (s - i);
        switch (kind_.generatrix) {
            case ref::Generatrix::kLinear:
                return (radius(i + 1, m) - radius(i, m)) * v;
            case ref::Generatrix::kParabola:
                return through<3>({-1, 0, 1}, v, rho) - rho(0);
            case ref::Generatrix::kCubic:
                break;
        }
        return cubic(v, rho) - rho(0);
    }

    double rho(const Cell& cell, double u, double w) const {
        const auto section = [&](int i) {
            return cubic(w, [&](int k) { return radius(i, cell.m + k); });
        };
        switch (kind_.surface) {
            case ref::Surface::kLagrange:
                return cubic(u, [&](int k) { return section(cell.i + k); });
            case ref::Surface::kCatmullRom:
                return catmull_rom(u, [&](int i) {
                    return catmull_rom(w, [&](int k) { return radius(cell.i + i, cell.m + k); });
                });
            default:
                break;
        }
        const bool middle = kind_.generatrix == ref::Generatrix::kCubic;
        const int s = cell.i + (cell.upper_u && !middle ? 1 : 0);
        if (kind_.surface == ref::Surface::kTamm) {
            return section(s) + rise(cell.i, s, cell.m + (cell.upper_w ? 1 : 0), u);
        }
        return section(s) + cubic(w, [&](int k) { return rise(cell.i, s, cell.m + k, u); });
    }

    std::vector<ref::CamSection> sections_;
    ref::SurfaceKind kind_;
    int n_;
    double dx_;
};

}  // namespace curvecore::tb
