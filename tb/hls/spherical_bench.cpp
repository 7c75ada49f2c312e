// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/spherical.cpp as Verilog, against hls/spherical_kernel.hpp.
#include "hls/spherical_kernel.hpp"
#include "tb/hls/segment_call.hpp"

int main(int argc, char** argv) {
    using namespace curvecore::tb;
    using C = curvecore::hls::TopConfiguration;
    return bench_main<SegmentCall<SphericalKernel<C>, random_segment<C>>>(argc, argv);
}
