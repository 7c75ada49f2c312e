// SPDX-License-Identifier: Apache-2.0
// Where a tube spline needs knots: what a cubic can follow, and how long it may last.
#pragma once

#include <vector>

#include "ref/path/tube/pace.hpp"
#include "ref/path/tube/programmed_path.hpp"

namespace curvecore::ref {

/// Turn at s, rad, between chords that noise within the tolerance does not bend.
double seen_turn(const ProgrammedPath& path, double s, double tolerance);

/// How the path runs at s as chords see it: the shortest, and those of several lengths that bend
/// least.
struct SeenBend {
    Vec3 direction = Vec3::Zero();
    double turn = 0;           // rad
    Vec3 bend = Vec3::Zero();  // 1/mm
};
SeenBend seen_bend(const ProgrammedPath& path, double s, double tolerance);

/// A place of the path as a tube of this tolerance sees it.
struct Site {
    double s;
    double turn;   // rad, as it is seen
    double speed;  // mm/s
    double width;  // mm, of a span here
};

/// At the joints and between them, from one place to another.
std::vector<Site> tube_sites(const ProgrammedPath& path, double from, double to, double tolerance,
                             const Pace& pace);

/// Widths that change from site to site no more than neighbouring spans may.
void even_widths(std::vector<Site>& sites);

/// Knots from the first site to the last, six spans at least; one at each of `fixed`.
std::vector<double> tube_knots(const std::vector<Site>& sites, const std::vector<double>& fixed);

}  // namespace curvecore::ref
