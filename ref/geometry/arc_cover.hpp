// SPDX-License-Identifier: Apache-2.0
// The planner's cuts of arcs, helices and lines of a range of radii, proven for every one of them.
#pragma once

#include "ref/bound/error_bound.hpp"

namespace curvecore::ref {

/// Result of family_bound() for all pieces whose radius is in the range.
///
/// | field          | unit   | meaning                                                          |
/// |----------------|--------|------------------------------------------------------------------|
/// | longest        | units  | a piece up to this length keeps the limit; 0: none does          |
/// | step_exponent  |        | of the longest step with which a piece of that length does       |
/// | bound          | units  | of such a piece                                                  |
/// | shortest       | units  | of the planner's pieces of an arc of a quarter turn or more, its |
/// |                |        | rule being fewest pieces, all alike                              |
/// | steps_per_unit | 1/unit | at most, of those pieces                                         |
struct ArcCover {
    double longest = 0;
    int step_exponent = 0;
    double bound = 0;
    double shortest = 0;
    double steps_per_unit = 0;
};

/// Radii in units, least > 0; limit in units.
///
/// A value longest > 0 proves that the planner refuses none of these moves (with pieces of that
/// length or shorter its search ends) and that every segment it makes keeps the limit.
ArcCover arc_cover(const CoreParameters& format, double least_radius, double most_radius,
                   double limit);

}  // namespace curvecore::ref
