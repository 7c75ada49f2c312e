// SPDX-License-Identifier: Apache-2.0
// Bounds of the distance between a configuration's words and the exact curve: derived, not tuned.
#pragma once

#include "ref/format/parameters.hpp"
#include "ref/format/path_words.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

// Of a core's parameters its error depends on Order, CoefBits, PositionBits, GuardBits, Mode and
// ParameterGuard.

/// Largest angle of an arc's step, rad.
constexpr double kMostTheta = 0.5;

/// Error bounds of arcs and lines per axis, in length units, before the final rounding, at any path
/// length of the segment. Fields read: curve, aux_advance, length, step_exponent.
double truncation_bound(const CoreParameters& format, const Segment& segment);
double rounding_bound(const CoreParameters& format, const Segment& segment);

/// Sum of both, or spline_error() of a spline; the planner keeps it below PlanOptions::error_limit.
double segment_bound(const CoreParameters& format, const Segment& segment);

/// Family of all arcs, helices and lines, in any direction of space, whose radius is in a range.
///
/// | field         | unit  | domain                                                      |
/// |---------------|-------|-------------------------------------------------------------|
/// | least_radius  | units | > 0; lines are in every family                              |
/// | most_radius   | units | >= least_radius                                             |
/// | length        | units | bound of a segment's path; it turns at most by pi / 2       |
/// | step_exponent |       | theta <= 2^step_exponent / least_radius <= kMostTheta       |
struct ArcFamily {
    double least_radius = 1;
    double most_radius = 1;
    double length = 1;
    int step_exponent = 0;
};

/// Upper limit of segment_bound() over the family's segments whose auxiliary axes are no faster
/// than the path. It is monotone in length, so one call proves all shorter segments too.
double family_bound(const CoreParameters& format, const ArcFamily& family);

}  // namespace curvecore::ref
