// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of hls/curves/spline.hpp.
#include "hls/curves/spline.hpp"

#include "hls/top/segment_top.hpp"

namespace curvecore {
namespace hls {

extern "C" void spline_hls(const SegmentFrame<TopConfiguration>& words,
                           const Word<kLengthBits + 1>& sigma, FinePosition& fine) {
    draw_sample<SplineCurve<TopConfiguration>>(words, sigma, fine);
}

}  // namespace hls
}  // namespace curvecore
