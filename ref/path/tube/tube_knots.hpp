// SPDX-License-Identifier: Apache-2.0
// Places of knots for a tube spline: spans that a cubic can follow, and their longest time.
#pragma once

#include <vector>

#include "ref/path/tube/pace.hpp"
#include "ref/path/tube/programmed_path.hpp"

namespace curvecore::ref {

/// Turn at s, rad, between chords that noise within the tolerance does not bend.
double seen_turn(const ProgrammedPath& path, double s, double tolerance);

/// Course of the path at s by chords: the shortest, and those of several lengths that bend least.
struct SeenBend {
    Vec3 direction = Vec3::Zero();
    double turn = 0;           // rad
    Vec3 bend = Vec3::Zero();  // 1/mm
};
SeenBend seen_bend(const ProgrammedPath& path, double s, double tolerance);

/// A place of the path in a tube of this tolerance.
struct Site {
    double s;
    double turn;   // rad, by chords
    double speed;  // mm/s
    double width;  // mm, width of a span here
};

/// Returns sites at the joints and between them, from one place to another.
std::vector<Site> tube_sites(const ProgrammedPath& path, double from, double to, double tolerance,
                             const Pace& pace);

/// Limits the change of widths from site to site to that of neighbouring spans.
void even_widths(std::vector<Site>& sites);

/// Returns knots from the first site to the last, six spans at least; one at each of `fixed`.
std::vector<double> tube_knots(const std::vector<Site>& sites, const std::vector<double>& fixed);

}  // namespace curvecore::ref
