// SPDX-License-Identifier: Apache-2.0
// The cutter's path over a cam, [Tamm]: a helix over the surface, cut into Archimedean pieces. A
// stream: sections go in, pieces come out, four sections are in memory.
//
// The spindle turns kappa half-turns while the part moves Dx, so an interval of angle moves it
// (1) D'x = 2 Dx / (kappa n), and kappa n / 2 is whole. In each cell of the table the radius on the
// helix is a polynomial of the angle; a piece ends where delta is used up, at a given angle (the
// knots), and where the surface switches sections or generatrices (the mid-lines). A piece begins
// where the one before ended: a jump of the surface becomes part of the next piece.
//
// A helix from the first section to the last leaves a wedge of one pitch on both. So the part turns
// once at rest along x before the helix, and once behind it.
#pragma once

#include <array>
#include <deque>
#include <functional>

#include "ref/cam/archimedean.hpp"
#include "ref/cam/cam_surface.hpp"

namespace curvecore::ref {

/// Ends of the path: a turn on the first and one on the last section, or the paper's helix alone.
enum class CamEnds { kTurn, kHelix };
constexpr std::array<std::string_view, 2> kCamEndNames{"turn", "helix"};

struct CamHelix {
    SurfaceKind kind;
    double kappa = 2;     // half-turns of the spindle per Dx
    double delta = 5e-3;  // mm, along the radius; rounding included
    CamEnds ends = CamEnds::kTurn;
};

/// Grid of a program's points, mm and degrees.
constexpr double kCamGrid = 1e-6;
constexpr double kLeastDelta = 1e-5;  // mm

/// Largest distance of kappa n / 2 from a whole number.
constexpr double kWholeIntervals = 1e-6;

/// A place of the cutter's centre.
struct CamPoint {
    double x = 0;      // mm
    double angle = 0;  // degrees, from the start
    double rho = 0;    // mm
};

struct CamPiece {
    CamPoint from, to;
    double deviation = 0;  // mm, of the piece from the surface, without the jump at its start
    double jump = 0;       // mm, of the surface where the piece begins
};

class CamPath {
  public:
    using Take = std::function<void(const CamPiece&)>;

    /// @throws std::invalid_argument: kappa n / 2 is not whole, delta below kLeastDelta
    CamPath(const CamHelix& helix, int angles, Take take);

    /// Takes the next section, in order; pieces come as soon as the sections that they need are
    /// there.
    /// @throws std::domain_error: the surface is too steep for kCamGrid and delta; finish() too
    void section(const CamSection& section);
    /// Ends the path after the last section; at least two have come.
    void finish();

    /// Intervals of angle per Dx.
    static double intervals(double kappa, int angles) { return kappa * angles / 2; }

  private:
    /// u = start + slope w between the window's middle sections, w from 0 over an interval of
    /// angle.
    struct Advance {
        double start, slope;
    };
    void between(const SectionWindow& window, bool last);
    void walk(const SectionWindow& window, long steps, Advance u);
    void cell(const Patch& patch, Advance u, double from, double to);
    CamPoint point(const PolarCurve& f, Advance u, double w) const;

    CamHelix helix_;
    int angles_;
    long per_section_;  // kappa n / 2
    Take take_;
    std::deque<std::vector<double>> rows_;  // radii of the last four sections
    double x0_ = 0;
    double pitch_ = 0;
    long sections_ = 0;
    long interval_ = 0;  // interval between sections in which the next pieces are
    long step_ = 0;      // interval of angle, counted from the start
    std::optional<CamPoint> last_;
};

/// Pitch of the helix, mm, at which a ball or round cutter of this radius leaves scallops of this
/// height: [Tamm] Fig. 6, H = 2 sqrt(2 R D - D^2).
double scallop_pitch(double cutter_radius, double scallop);
/// Height of the scallops that this pitch leaves, mm.
double scallop_height(double cutter_radius, double pitch);

/// Least kappa with kappa n / 2 whole whose pitch 2 Dx / kappa is at most `pitch`.
double kappa_for(double pitch, double dx, int angles);

}  // namespace curvecore::ref
