// SPDX-License-Identifier: Apache-2.0
// A call of the function of hls/top/segment_top.hpp, and the result of the kernel.
#pragma once

#include "hls/top/top_configuration.hpp"
#include "ref/curve/axes.hpp"
#include "tb/hls/pipeline_bench.hpp"

namespace curvecore::tb {

/// A call with random_segment or random_spline. The RTL draws a sample at every clock.
template <class Kernel, SegmentWords<TopConfiguration> (*segment_of)(Random&)>
struct SegmentCall {
    using C = TopConfiguration;
    static constexpr int bits = C::kFineBits;
    static constexpr int rtl_clocks = rtl_core().sample_interval;

    void draw(Random& random) {
        const SegmentWords<C> segment = segment_of(random);
        pack(segment, 0, words);
        sigma = int64_t(random.uniform(0, std::ldexp(1.0, segment.step_exponent + kPathFrac)));
        Kernel kernel;
        kernel.load(segment);
        for (int step = 0; step < CFG_Steps; ++step) kernel.step();
        C::Fine fine[C::kAxes];
        kernel.sample(sigma, fine);
        expected.assign(fine, fine + C::kAxes);
    }

    void drive(Vhls& dut) const {
        for (int n = 0; n < kWords; ++n) {
            sysc::set_field(dut.words_i, n * kBusBits, kBusBits, static_cast<int64_t>(words[n]));
        }
        dut.sigma_i = static_cast<uint64_t>(sigma);
    }

    static constexpr int kWords = 17 + 3 * C::kAuxAxes;
    uint64_t words[kWords] = {};
    int64_t sigma = 0;
    std::vector<int64_t> expected;
};

}  // namespace curvecore::tb
