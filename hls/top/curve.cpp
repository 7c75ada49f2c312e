// SPDX-License-Identifier: Apache-2.0
// Top of the HLS of a table's kernel, whose header is included on the command line: CFG_Kernel is
// its class, CFG_Top the name of the function.
#include "hls/top/segment_top.hpp"

namespace curvecore {
namespace hls {

using CurveConfiguration = WithFurther<TopConfiguration, CFG_Kernel<TopConfiguration>::kFurther>;

extern "C" void CFG_Top(const SegmentFrame<CurveConfiguration>& words,
                        const Word<kLengthBits + 1>& sigma, FinePosition& fine) {
    draw_sample<CFG_Kernel<CurveConfiguration>, CurveConfiguration>(words, sigma, fine);
}

}  // namespace hls
}  // namespace curvecore
