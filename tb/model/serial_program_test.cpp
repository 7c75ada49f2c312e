// SPDX-License-Identifier: Apache-2.0
// The serial build's program of splines makes the words of hls::SplineKernel in every order, and no
// word is read before it is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hls/spline_kernel.hpp"
#include "tb/support/serial_machine.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {
namespace {

using hls::SamplerMode;

template <class C>
class SerialProgram : public testing::Test {};

using Configurations =
    testing::Types<hls::Configuration<2, 18, 16, 2, 0, SamplerMode::kPolynomial>,
                   hls::Configuration<3, 20, 20, 4, 1, SamplerMode::kSeries>,
                   hls::Configuration<4, 36, 32, 10, 0, SamplerMode::kPolynomial>,
                   hls::Configuration<5, 24, 24, 8, 4, SamplerMode::kPolynomial>,
                   hls::Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries>,
                   hls::Configuration<7, 27, 28, 7, 6, SamplerMode::kPolynomial>,
                   hls::Configuration<8, 36, 32, 12, 0, SamplerMode::kPolynomial>,
                   hls::Configuration<9, 35, 31, 11, 0, SamplerMode::kSeries>,
                   hls::Configuration<10, 33, 32, 9, 0, SamplerMode::kPolynomial>,
                   hls::Configuration<11, 29, 26, 5, 0, SamplerMode::kPolynomial>,
                   hls::Configuration<12, 36, 32, 10, 2, SamplerMode::kSeries>>;
TYPED_TEST_SUITE(SerialProgram, Configurations);

TYPED_TEST(SerialProgram, MakesTheKernelsWords) {
    using C = TypeParam;
    SplineSegments<C> shapes(3);
    SerialMachine<C> machine;
    hls::SplineKernel<C> kernel;
    std::mt19937_64 random(5);
    for (int n = 0; n < 60; ++n) {
        hls::SegmentWords<C> words = shapes.next();
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
            hls::Word<C::kFineBits> drawn[C::kAxes];
            hls::Word<C::kFineBits> expected[C::kAxes];
            machine.sample(sigma, drawn);
            kernel.sample(sigma, expected);
            for (int axis = 0; axis < C::kAxes; ++axis) {
                ASSERT_EQ(drawn[axis], expected[axis]) << "segment " << n << " step " << m;
            }
        }
    }
}

}  // namespace
}  // namespace curvecore::tb
