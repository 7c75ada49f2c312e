// SPDX-License-Identifier: Apache-2.0
// Results of a frame's preparation besides its coefficients, [Obukhov] "data preparation": the
// derivatives at both ends, the sharpest place.
#pragma once

#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// | field         | unit    | remark                                                          |
/// |---------------|---------|-----------------------------------------------------------------|
/// | tangent_*     | 1       | dr/ds at start and end; shorter than 1 where only auxiliary     |
/// |               |         | axes move or one of them is the fastest                         |
/// | curvature_*   | 1/units | |d2r/ds2| there; infinite at a cusp                             |
/// | most          | 1/units | largest curvature of the segment                                |
/// | most_at       | units   | path from the segment's start to it                             |
struct SegmentShape {
    Vec3 tangent_start = Vec3::Zero();
    Vec3 tangent_end = Vec3::Zero();
    double curvature_start = 0;
    double curvature_end = 0;
    double most = 0;
    double most_at = 0;
};

/// Shape of a segment. Error of `most`: 1e-6 of it; for a spline by search between 64 places.
SegmentShape segment_shape(const Segment& segment);

}  // namespace curvecore::ref
