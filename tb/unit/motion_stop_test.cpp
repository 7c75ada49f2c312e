// SPDX-License-Identifier: Apache-2.0
// rtl/motion_interpolator.sv with stop branches between its pieces: every rate is the kernel's.
#include "tb/support/motion_bench.hpp"

namespace curvecore::tb {
namespace {

using MotionStop = MotionInterpolator;

TEST_F(MotionStop, EqualsKernelsUnderHoldsAndOverrides) {
    rates_ = Rates::kOfKernel;
    branch_percent_ = 60;
    int64_t stops = 0;
    for (int round = 0; round < 30; ++round) {
        program(pieces(static_cast<uint32_t>(500 + round), 60, 10, 60, 3 << 16));
        fill();
        const auto every =
            static_cast<unsigned>(50 << round % 4) * static_cast<unsigned>(core_.sample_interval);
        run([&] {
            if (random_() % every == 0) dut_->hold_i = random_() % 2;
            if (random_() % (8 * every) == 0) {
                dut_->override_i = random_() % 3 == 0 ? random_() % 65537 : 65536;
            }
        });
        if (HasFatalFailure()) FAIL() << "round " << round;
        dut_->hold_i = 0;
        dut_->override_i = 65536;
        stops = steps_;
    }
    EXPECT_GT(stops, 50);
}

}  // namespace
}  // namespace curvecore::tb
