// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/spline.cpp as Verilog, against hls/curves/spline.hpp.
#include "hls/curves/spline.hpp"
#include "tb/hls/segment_call.hpp"

int main(int argc, char** argv) {
    using namespace curvecore::tb;
    using C = curvecore::hls::TopConfiguration;
    return bench_main<SegmentCall<SplineCurve<C>, random_spline<C>>>(argc, argv);
}
