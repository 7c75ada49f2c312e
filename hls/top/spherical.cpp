// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of hls/curves/arc.hpp.
#include "hls/curves/arc.hpp"
#include "hls/top/segment_top.hpp"

namespace curvecore {
namespace hls {

extern "C" void spherical_hls(const SegmentFrame<TopConfiguration>& words,
                              const Word<kLengthBits + 1>& sigma, FinePosition& fine) {
    draw_sample<ArcCurve<TopConfiguration>>(words, sigma, fine);
}

}  // namespace hls
}  // namespace curvecore
