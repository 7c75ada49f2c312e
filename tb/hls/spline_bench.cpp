// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/spline.cpp as Verilog, against hls/spline_kernel.hpp.
#include "hls/spline_kernel.hpp"
#include "tb/hls/segment_call.hpp"

int main(int argc, char** argv) {
    using namespace curvecore::tb;
    using C = curvecore::hls::TopConfiguration;
    return bench_main<SegmentCall<SplineKernel<C>, random_spline<C>>>(argc, argv);
}
