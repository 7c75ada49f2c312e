// SPDX-License-Identifier: Apache-2.0
// A spline segment drawn by the kernel whose words throw on overflow. For files that define
// CURVECORE_CHECKED.
#pragma once

#include <algorithm>

#include "hls/curves/spline.hpp"
#include "hls/quantise.hpp"

#if !defined(CURVECORE_CHECKED)
#error "define CURVECORE_CHECKED before the first header"
#endif

namespace curvecore::tb {

/// Draws every step of a segment, and samples at its ends and between.
/// @throws std::range_error when a value leaves its word's range
template <class C>
void draw_checked(const ref::Segment& segment) {
    hls::SplineCurve<C> kernel;
    kernel.load(hls::to_words<C>(segment));
    const auto step = std::int64_t(1) << (segment.step_exponent + hls::kPathFrac);
    for (auto rest = static_cast<std::int64_t>(segment.length);; rest -= step) {
        const std::int64_t span = std::min(rest, step) - 1;
        for (const std::int64_t sigma : {std::int64_t(0), span / 3, span / 2, span}) {
            hls::Word<C::kFineBits> out[C::kAxes];
            kernel.sample(sigma, out);
        }
        if (rest <= step) return;
        kernel.step();
    }
}

}  // namespace curvecore::tb
