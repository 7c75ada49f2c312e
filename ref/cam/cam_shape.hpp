// SPDX-License-Identifier: Apache-2.0
// A cam's surface as a whole: its radius anywhere, how good its table is, what it saves.
#pragma once

#include "ref/cam/cam_surface.hpp"

namespace curvecore::ref {

class CamShape {
  public:
    /// Makes the surface from at least two sections.
    CamShape(std::vector<CamSection> sections, SurfaceKind kind);

    int angles() const { return angles_; }
    double pitch() const { return pitch_; }  // Dx, mm
    double first_x() const { return sections_.front().x; }
    double last_x() const { return sections_.back().x; }
    std::size_t sections() const { return sections_.size(); }

    /// | field       | unit   | remark                                                |
    /// |-------------|--------|-------------------------------------------------------|
    /// | rho         | mm     |                                                       |
    /// | by_theta    | mm/rad | d rho / d theta                                       |
    /// | by_x        | 1      | d rho / dx                                            |
    /// | bend_theta  | mm/rad^2 | second derivatives                                  |
    /// | bend_x      | 1/mm   |                                                       |
    struct Place {
        double rho, by_theta, by_x, bend_theta, bend_x;
    };

    /// Evaluates the surface at x in mm, also a little beyond the ends, and theta in degrees, any
    /// number of turns.
    Place at(double x, double degrees) const;

    /// Largest jump of the surface between cells, mm, on `grid` places of each of their sides.
    double largest_jump(int grid = 16) const;

    /// Estimated error of interpolation between the table's radii, mm: every radius from its
    /// neighbours once and thrice removed, scaled to half the distance by the order of the
    /// interpolation; the sum of the worst along angle and axis.
    double own_error() const;

    /// Number of radii of the smallest table that keeps `error` (mm) of this surface when it is
    /// read linearly both ways ([Tamm] "Conclusions" 2), over all ratios of Dx to Dtheta, from the
    /// second derivatives. At a cell's middle and on its edges such a table misses (Dtheta^2 rho_tt
    /// + Dx^2 rho_xx) / 8 and the two parts of it.
    double linear_radii(double error) const;

    /// Pieces per turn at delta (mm), when no knot cuts them: the integral of sqrt(|f''| / 8 delta)
    /// along the section at x.
    double pieces_per_turn(double x, double delta) const;

  private:
    struct Cell {
        Patch patch;
        double u, w;
    };
    Cell cell(double x, double degrees) const;
    Patch patch(int i, int m, int half_u, int half_w) const;

    std::vector<CamSection> sections_;
    std::vector<double> before_, after_;  // ghosts
    SurfaceKind kind_;
    int angles_;
    double pitch_;
};

}  // namespace curvecore::ref
