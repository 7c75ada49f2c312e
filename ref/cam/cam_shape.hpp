// SPDX-License-Identifier: Apache-2.0
// A cam's surface as a whole: radius at any place, how good its table is, what it saves.
#pragma once

#include "ref/cam/cam_surface.hpp"

namespace curvecore::ref {

class CamShape {
  public:
    /// At least two sections.
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

    /// At x in mm, a little beyond the ends too, and theta in degrees, any number of turns.
    Place at(double x, double degrees) const;

    /// Largest jump of the surface between cells, mm, on `grid` places of each of their sides.
    double largest_jump(int grid = 16) const;

    /// What interpolation between the table's radii is estimated to miss, mm: every radius from
    /// its neighbours once and thrice removed, scaled to half the distance by the order of the
    /// interpolation. Along angle and axis, the worst of each, added up.
    double own_error() const;

    /// [Tamm] "Conclusions" 2: how many radii a table has that, read linearly both ways, keeps
    /// `error` (mm) of this surface: the fewest, of any ratio of Dx to Dtheta, from the second
    /// derivatives. At a cell's middle and on its edges such a table misses
    /// (Dtheta^2 rho_tt + Dx^2 rho_xx) / 8 and the two parts of it.
    double linear_radii(double error) const;

    /// Pieces per turn that delta (mm) asks for, of pieces that no knot cuts: the integral of
    /// sqrt(|f''| / 8 delta) along the section at x.
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
