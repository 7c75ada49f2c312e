// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/sine_cosine.cpp as Verilog, against hls::SineCosineNetwork.
#include "hls/curves/sine_cosine.hpp"
#include "hls/top/top_configuration.hpp"
#include "tb/hls/pipeline_bench.hpp"

namespace curvecore::tb {
namespace {

/// A call with any angle of a step below 1, and any state on the circle.
struct SineCosineCall {
    using C = TopConfiguration;
    static constexpr int bits = C::kCoefBits;
    static constexpr int rtl_clocks = sine_cosine_step_clocks(rtl_core());

    void draw(Random& random) {
        theta =
            int64_t(std::ldexp(random.uniform(0.5, 1), C::kUnitFrac)) >> int(random.uniform(0, 12));
        const double angle = random.uniform(-4, 4);
        sine = std::llround(std::ldexp(std::sin(angle), C::kCoefFrac));
        cosine = std::llround(std::ldexp(std::cos(angle), C::kCoefFrac));
        SineCosineNetwork<C> node;
        node.load(theta, sine, cosine);
        expected.assign(node.y_ + 1, node.y_ + C::kOrder + 1);
        expected.insert(expected.end(), node.z_ + 1, node.z_ + C::kOrder + 1);
        node.step();
        expected.push_back(node.y_[0]);
        expected.push_back(node.z_[0]);
    }

    void drive(Vhls& dut) const {
        sysc::set_field(dut.theta_i, 0, bits, theta);
        sysc::set_field(dut.sine_i, 0, bits, sine);
        sysc::set_field(dut.cosine_i, 0, bits, cosine);
    }

    C::Coef theta = 0;
    C::Coef sine = 0;
    C::Coef cosine = 0;
    std::vector<int64_t> expected;
};

}  // namespace
}  // namespace curvecore::tb

int main(int argc, char** argv) {
    return curvecore::tb::bench_main<curvecore::tb::SineCosineCall>(argc, argv);
}
