// SPDX-License-Identifier: Apache-2.0
// How far the words of a configuration may leave the exact curve: derived, not tuned.
#pragma once

#include "ref/format/parameters.hpp"
#include "ref/format/path_words.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

// Of a core's parameters its error depends on Order, CoefBits, PositionBits, GuardBits, Mode,
// TurnBits and ParameterGuard.

/// Rad in a step of an arc, at most.
double max_theta(const CoreParameters& format);

/// Errors of arcs and lines per axis, in length units, before the final rounding, at any path
/// length of the segment. Read from the segment: radius, cos_pitch, advance, aux_advance, length,
/// step_exponent.
double truncation_bound(const CoreParameters& format, const Segment& segment);
double rounding_bound(const CoreParameters& format, const Segment& segment);

/// Their sum, or spline_error() of a spline: what the planner keeps below PlanOptions::error_limit.
double segment_bound(const CoreParameters& format, const Segment& segment);

/// Every arc, helix and line segment, in any direction of space, whose radius is in a range.
///
/// | field         | unit  | domain                                                      |
/// |---------------|-------|-------------------------------------------------------------|
/// | least_radius  | units | > 0; lines are in every family                              |
/// | most_radius   | units | >= least_radius                                             |
/// | length        | units | the segment's path is at most so long, and a quarter turn   |
/// | step_exponent |       | theta <= 2^step_exponent / least_radius <= max_theta()      |
struct ArcFamily {
    double least_radius = 1;
    double most_radius = 1;
    double length = 1;
    int step_exponent = 0;
};

/// At least segment_bound() of each segment of the family whose auxiliary axes are no faster than
/// the path. Monotone in length, so one call proves the shorter segments too.
double family_bound(const CoreParameters& format, const ArcFamily& family);

}  // namespace curvecore::ref
