// SPDX-License-Identifier: Apache-2.0
#include "ref/plan/segment_shape.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "ref/plan/curve_follower.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 64;
constexpr int kBits = 26;  // bits of a minimum's place: half a double's

/// Returns the parameter of the largest curvature.
double sharpest(const Cubic& cubic) {
    const auto bend = [&cubic](double u) { return -curvature(cubic, u); };
    int best = 0;
    for (int i = 1; i <= kPlaces; ++i) {
        if (bend(static_cast<double>(i) / kPlaces) < bend(static_cast<double>(best) / kPlaces)) {
            best = i;
        }
    }
    const double low = std::max(best - 1, 0) / static_cast<double>(kPlaces);
    const double high = std::min(best + 1, kPlaces) / static_cast<double>(kPlaces);
    const double inside = boost::math::tools::brent_find_minima(bend, low, high, kBits).first;
    const double place = static_cast<double>(best) / kPlaces;
    return bend(inside) < bend(place) ? inside : place;
}

}  // namespace

SegmentShape segment_shape(const Segment& segment) {
    CurveFollower curve;
    const double length = std::ldexp(static_cast<double>(segment.length), -16);
    SegmentShape shape;
    shape.tangent_start = curve.direction(segment, 0);
    shape.tangent_end = curve.direction(segment, length);
    shape.curvature_start = curve.curvature(segment, 0);
    shape.curvature_end = curve.curvature(segment, length);
    shape.most = shape.curvature_start;
    if (segment.kind == Segment::Kind::kSpline) {
        const Cubic cubic = to_cubic(segment);
        const double u = sharpest(cubic);
        shape.most = curvature(cubic, u);
        shape.most_at = arc_length(cubic, 0, u);
    }
    return shape;
}

}  // namespace curvecore::ref
