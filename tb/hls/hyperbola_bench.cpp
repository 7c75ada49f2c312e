// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/hyperbola.cpp as Verilog, against hls::HyperbolaNetwork.
#include "hls/curves/hyperbola.hpp"
#include "hls/top/top_configuration.hpp"
#include "tb/hls/pipeline_bench.hpp"

namespace curvecore::tb {
namespace {

/// A call with any legal start, of any size.
struct HyperbolaCall {
    using C = TopConfiguration;
    static constexpr int bits = C::kCoefBits;
    static constexpr int rtl_clocks = hyperbola_step_clocks(rtl_core(), true);

    void draw(Random& random) {
        start = int64_t(std::ldexp(random.uniform(0.5, 1), bits - 1)) >> int(random.uniform(0, 12));
        HyperbolaNetwork<C> kernel;
        kernel.load(start);
        for (int step = 0; step < CFG_Steps; ++step) kernel.step();
        expected.assign(kernel.y_, kernel.y_ + C::kOrder + 1);
        expected.insert(expected.end(), kernel.z_, kernel.z_ + C::kTop + 1);
        kernel.step();
        expected.push_back(kernel.y_[0]);
    }

    void drive(Vhls& dut) const { sysc::set_field(dut.start_i, 0, bits, start); }

    C::Coef start = 0;
    std::vector<int64_t> expected;
};

}  // namespace
}  // namespace curvecore::tb

int main(int argc, char** argv) {
    return curvecore::tb::bench_main<curvecore::tb::HyperbolaCall>(argc, argv);
}
