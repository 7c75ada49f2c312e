// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/spherical.cpp as Verilog, against hls/curves/arc.hpp.
#include "hls/curves/arc.hpp"
#include "tb/hls/segment_call.hpp"

int main(int argc, char** argv) {
    using namespace curvecore::tb;
    using C = curvecore::hls::TopConfiguration;
    return bench_main<SegmentCall<ArcCurve<C>, random_segment<C>>>(argc, argv);
}
