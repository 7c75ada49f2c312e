// SPDX-License-Identifier: Apache-2.0
// The exact curve of a plan, sample by sample in the order of the path.
#pragma once

#include <cmath>
#include <optional>

#include "ref/plan/segment_curve.hpp"

namespace curvecore::ref {

/// Evaluates exact_position() and the curvature; the table of a spline's path length is kept while
/// the segment stays the same; its ends need none.
///
/// | function  | unit    | error                                     |
/// |-----------|---------|-------------------------------------------|
/// | position  | units   | that of exact_position()                  |
/// | direction | 1       | r'; roundings                             |
/// | bend      | 1/units | r''; roundings                            |
/// | curvature | 1/units | of |r''|; roundings. Infinite at a cusp   |
class CurveFollower {
  public:
    /// Position at s: units, local to the segment, which must outlive the calls that follow.
    Vec3 position(const Segment& segment, double s) {
        if (segment.kind != Segment::Kind::kSpline) return exact_position(segment, s);
        const double u = parameter(segment, s);
        return cubic_.position(u);
    }

    Vec3 direction(const Segment& segment, double s) {
        if (segment.kind == Segment::Kind::kSpline) {
            const double u = parameter(segment, s);
            return tangent(cubic_, u);
        }
        if (segment.radius == 0) return segment.advance;
        const double angle = s * segment.cos_pitch / segment.radius;
        return segment.advance + segment.cos_pitch * (segment.tangent * std::cos(angle) -
                                                      segment.normal * std::sin(angle));
    }

    Vec3 bend(const Segment& segment, double s) {
        if (segment.kind == Segment::Kind::kSpline) {
            const double u = parameter(segment, s);
            return curvature_vector(cubic_, u);
        }
        if (segment.radius == 0) return Vec3::Zero();
        const double twist = segment.cos_pitch / segment.radius;
        return -segment.cos_pitch * twist *
               (segment.normal * std::cos(twist * s) + segment.tangent * std::sin(twist * s));
    }

    double curvature(const Segment& segment, double s) {
        if (segment.kind == Segment::Kind::kSpline) {
            const double u = parameter(segment, s);
            return ref::curvature(cubic_, u);
        }
        return segment.radius > 0 ? segment.cos_pitch * segment.cos_pitch / segment.radius : 0;
    }

  private:
    double parameter(const Segment& segment, double s) {
        if (&segment != segment_) {
            segment_ = &segment;
            cubic_ = to_cubic(segment);
            path_.reset();
        }
        if (s <= 0) return 0;
        if (s >= std::ldexp(static_cast<double>(segment.length), -16)) return 1;
        if (!path_) path_.emplace(cubic_);
        return path_->parameter(s);
    }

    const Segment* segment_ = nullptr;
    Cubic cubic_;
    std::optional<ArcLength> path_;
};

}  // namespace curvecore::ref
