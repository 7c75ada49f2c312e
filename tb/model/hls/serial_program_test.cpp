// SPDX-License-Identifier: Apache-2.0
// The serial build's program of splines makes the words of hls::SplineCurve in every order, and
// reads no word before it is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hls/curves/spline.hpp"
#include "tb/support/bench/serial_machine.hpp"
#include "tb/support/segments/spline_segments.hpp"

namespace curvecore::tb::serial_program_test {

class SerialProgram : public testing::TestWithParam<CoreParameters> {};

CoreParameters widths(int order, int coef, int position, int guard, int aux, int mode) {
    CoreParameters core;
    core.order = order;
    core.coef_bits = coef;
    core.position_bits = position;
    core.guard_bits = guard;
    core.aux_axes = aux;
    core.mode = mode;
    return core;
}

INSTANTIATE_TEST_SUITE_P(Widths, SerialProgram,
                         testing::Values(widths(2, 18, 16, 2, 0, 1), widths(3, 20, 20, 4, 1, 0),
                                         widths(4, 36, 32, 10, 0, 1), widths(5, 24, 24, 8, 4, 1),
                                         widths(6, 36, 32, 10, 0, 0), widths(7, 27, 28, 7, 6, 1),
                                         widths(8, 36, 32, 12, 0, 1), widths(9, 35, 31, 11, 0, 0),
                                         widths(10, 33, 32, 9, 0, 1), widths(11, 29, 26, 5, 0, 1),
                                         widths(12, 36, 32, 10, 2, 0)),
                         [](const testing::TestParamInfo<CoreParameters>& core) {
                             return "order_" + std::to_string(core.param.order);
                         });

TEST_P(SerialProgram, MakesTheKernelsWords) {
    const RunTimeFormat format(GetParam(), GetParam().axes());
    SplineSegments shapes(GetParam(), 3);
    SerialMachine machine(format);
    hls::SplineCurve<RunTimeFormat> kernel(format);
    std::mt19937_64 random(5);
    for (int n = 0; n < 60; ++n) {
        RunSegment words = shapes.next();
        if (n % 2 == 0) words.step_exponent %= 1 + n % 20;  // shorter steps are legal
        const int64_t step = int64_t{1} << (words.step_exponent + hls::kPathFrac);
        const int64_t steps = std::min<int64_t>(words.length / step, 3);
        machine.load(words);
        kernel.load(words);
        for (int64_t m = 0; m < steps; ++m) {
            if (m > 0) {
                machine.step();
                kernel.step();
            }
            const auto sigma = static_cast<int64_t>(random() % static_cast<unsigned long>(step));
            std::int64_t drawn[kMostAxes];
            std::int64_t expected[kMostAxes];
            machine.sample(sigma, drawn);
            kernel.sample(sigma, expected);
            for (int axis = 0; axis < GetParam().axes(); ++axis) {
                ASSERT_EQ(drawn[axis], expected[axis]) << "segment " << n << " step " << m;
            }
        }
    }
}

}  // namespace curvecore::tb::serial_program_test
