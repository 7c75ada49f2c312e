// SPDX-License-Identifier: Apache-2.0
// Both curves from one stream of segments: the kernel of a core that draws lines, arcs and splines.
// Twin: rtl/curve_interpolator.sv.
#pragma once

#include "hls/curves/spline.hpp"
#include "hls/interpolator_kernel.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

template <class C>
class CurveKernel {
  public:
    CurveKernel() = default;
    explicit CurveKernel(const C& format) : arc_(format), spline_(format) {}

    void load(const SegmentWords<C>& segment) {
        spline_now_ = segment.kind == SegmentKind::kSpline;
        spline_now_ ? spline_.load(segment) : arc_.load(segment);
    }

    void step() { spline_now_ ? spline_.step() : arc_.step(); }

    void sample(const Word<kLengthBits + 1>& sigma, typename C::Fine* out) const {
        spline_now_ ? spline_.sample(sigma, out) : arc_.sample(sigma, out);
    }

  private:
    bool spline_now_ = false;
    ArcCurve<C> arc_;
    SplineCurve<C> spline_;
};

/// The kernel of a stream of segments of both kinds.
template <class C>
using MotionKernel = InterpolatorKernel<C, CurveKernel<C>>;

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
