// SPDX-License-Identifier: Apache-2.0
// Bench of hls/top/curve.cpp as Verilog, against the table's kernel in words that throw when a
// value leaves their range: random words of such segments as keep all ranges.
#include <stdexcept>

#include "hls/top/top_configuration.hpp"
#include "tb/hls/pipeline_bench.hpp"

namespace curvecore::tb {

struct CurveCall {
    using C = WithFurther<TopConfiguration, CFG_Kernel<TopConfiguration>::kFurther>;
    static constexpr int bits = C::kFineBits;
    static constexpr int rtl_clocks = 0;  // no RTL of its own

    void draw(Random& random) {
        for (int tries = 0; tries < 10000; ++tries) {
            try {
                draw_any(random);
                return;
            } catch (const std::range_error&) {
            }
        }
        throw std::runtime_error("no random segment keeps the words' ranges");
    }

    void drive(Vhls& dut) const {
        for (int n = 0; n < kWords; ++n) {
            sysc::set_field(dut.words_i, n * kBusBits, kBusBits, static_cast<int64_t>(words[n]));
        }
        dut.sigma_i = static_cast<uint64_t>(sigma);
    }

    static constexpr int kWords = 17 + 3 * C::kAuxAxes + C::kFurtherWords;
    uint64_t words[kWords] = {};
    int64_t sigma = 0;
    std::vector<int64_t> expected;

  private:
    void draw_any(Random& random) {
        SegmentWords<C> segment;
        segment.kind = SegmentKind::kTable;
        segment.length = 1;
        segment.step_exponent = static_cast<int>(random.uniform(0, C::kPositionBits - 6));
        segment.lambda = segment.step_exponent + static_cast<int>(random.uniform(0, 5));
        const auto word = [&](int bits_of) {
            const double most = std::ldexp(1, bits_of - 1);
            return static_cast<int64_t>(random.uniform(-most, most));
        };
        const int coef = C::kCoefBits - 1 - static_cast<int>(random.uniform(0, 6));
        segment.theta = word(coef);
        for (int axis = 0; axis < C::kAxes; ++axis) {
            segment.start[axis] = word(C::kFineBits - 2);
            segment.advance[axis] = word(coef);
            if (axis >= 3) continue;
            segment.tangent[axis] = word(coef);
            segment.normal[axis] = word(coef);
        }
        for (int n = 0; n < C::kFurtherWords; ++n) segment.further[n] = word(coef);
        pack(segment, 0, words);
        sigma = static_cast<int64_t>(
            random.uniform(0, std::ldexp(1.0, segment.step_exponent + kPathFrac)));
        CFG_Kernel<C> kernel;
        kernel.load(segment);
        for (int step = 0; step < CFG_Steps; ++step) kernel.step();
        C::Fine fine[C::kAxes];
        kernel.sample(sigma, fine);
        expected.clear();
        for (const C::Fine& one : fine) expected.push_back(to_int(one));
    }
};

}  // namespace curvecore::tb

int main(int argc, char** argv) {
    return curvecore::tb::bench_main<curvecore::tb::CurveCall>(argc, argv);
}
