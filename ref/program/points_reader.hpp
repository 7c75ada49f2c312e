// SPDX-License-Identifier: Apache-2.0
// Files of points (.csv) to moves: a spline through the points.
//
//     # a comment, also behind numbers
//     x, y, z, a                the header may be missing: then x y z a b c u v w in this order
//     0, 0, 0, 0
//     10, 2.5, -1e-3, 45
//
// Numbers stand between commas, semicolons, blanks or tabs. Columns: x y (required), z (0 if it is
// missing), a b c u v w (auxiliary axes, linear in path length between the points), dx dy dz and
// ddx ddy ddz (derivatives by the spline's parameter, for the fits that read them; their cells may
// be empty where the fit does not; the fits that read all of them derive them from the positions if
// the columns are missing). Lengths in mm, angles in degrees.
#pragma once

#include <string>
#include <string_view>

#include "ref/curve/fit/point_fit.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

struct PointsOptions {
    Fit fit = Fit::kBessel;
    Ends ends = Ends::kNatural;  // for the fit c2
    Parametrisation parametrisation = Parametrisation::kChord;
    double feed = 1000.0 / 60;             // mm/s
    double fit_tolerance = kFitTolerance;  // mm, for quintics
};

/// Reads points; a move's line is that of the point it leads to. The program begins at the first
/// point.
/// @throws InputError
Program read_points(const std::string& file, const PointsOptions& options);

/// @throws InputError, with `file_name` as its file
Program read_points_text(std::string_view text, const std::string& file_name,
                         const PointsOptions& options);

}  // namespace curvecore::ref
