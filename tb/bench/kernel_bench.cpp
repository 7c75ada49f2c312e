// SPDX-License-Identifier: Apache-2.0
// Speed of the arc kernel on one core, beside the same loop written by hand in plain integers for
// the default configuration. Rates are samples per second.
#include <benchmark/benchmark.h>

#include <cmath>

#include "hls/interpolator_kernel.hpp"

namespace {

using namespace curvecore::hls;
using C = DefaultConfiguration;

constexpr double kRadius = 25e6;  // 25 mm at 1 nm
constexpr int kStep = 21;         // 2.1 mm: theta = 0.084

/// A whole turn, so that the stream neither ends nor waits.
SegmentWords<C> turn() {
    SegmentWords<C> segment;
    segment.length = std::llround(2 * M_PI * kRadius * 65536);
    segment.step_exponent = kStep;
    segment.theta = std::llround(std::ldexp(std::ldexp(1.0, kStep) / kRadius, C::kUnitFrac));
    segment.start[0] = std::llround(std::ldexp(kRadius, C::kGuardBits));
    segment.end[0] = segment.start[0];
    segment.normal[0] = std::int64_t(1) << C::kCoefFrac;
    segment.tangent[1] = std::int64_t(1) << C::kCoefFrac;
    return segment;
}

void kernel_samples(benchmark::State& state) {
    const std::int64_t ds = (std::int64_t(1) << (kStep + kPathFrac)) / state.range(0);
    const SegmentWords<C> segment = turn();
    InterpolatorKernel<C> kernel;
    for (auto _ : state) {
        Word<C::kFineBits> fine[C::kAxes];
        kernel.sample(
            ds, [&]() -> const SegmentWords<C>& { return segment; }, fine);
        benchmark::DoNotOptimize(fine);
    }
    state.SetItemsProcessed(state.iterations());
}

/// The hand-written loop: order 6, 36-bit words, three axes, nothing general.
class ByHand {
  public:
    using Int = std::int64_t;
    __extension__ using Wide = __int128;

    static Int mul(Int a, Int b) { return static_cast<Int>((Wide(a) * b + (Wide(1) << 34)) >> 35); }
    static Int fine(Int d) { return ((((d << 3) << 1) >> (27 - kStep)) + 1) >> 1; }

    explicit ByHand(const SegmentWords<C>& segment) : length_(segment.length) {
        weight_[1] = segment.theta;
        for (int i = 2; i <= 6; ++i) weight_[i] = mul(weight_[1], reciprocal(i, 35));
        for (int axis = 0; axis < 3; ++axis) {
            start_[axis] = segment.start[axis];
            n_[axis] = segment.normal[axis];
            t_[axis] = segment.tangent[axis];
        }
        restart();
    }

    void sample(Int ds, Int* out) {
        sigma_ += ds;
        if (sigma_ >= kFull) {
            sigma_ -= kFull;
            rest_ -= kFull;
            rest_ > 0 ? step() : restart();
        }
        const Int tau = ((sigma_ << (27 - kStep)) & ((Int(1) << 43) - 1)) >> 8;
        for (int axis = 0; axis < 3; ++axis) {
            const Int* c = c_[axis];
            Int d = c[6];
            d = c[5] + mul(d, tau);
            d = c[4] + mul(d, tau);
            d = c[3] + mul(d, tau);
            d = c[2] + mul(d, tau);
            d = c[1] + mul(d, tau);
            out[axis] = position_[axis] + fine(mul(d, tau));
        }
    }

  private:
    static constexpr Int kFull = Int(1) << (kStep + 16);

    void restart() {
        rest_ = length_;
        for (int axis = 0; axis < 3; ++axis) {
            position_[axis] = start_[axis];
            y_[axis] = n_[axis];
            z_[axis] = t_[axis];
            expand(axis);
        }
    }

    void expand(int axis) {
        c_[axis][1] = z_[axis];
        e_[axis][1] = -y_[axis];
        for (int i = 2; i <= 6; ++i) {
            c_[axis][i] = mul(weight_[i], e_[axis][i - 1]);
            e_[axis][i] = mul(weight_[i], -c_[axis][i - 1]);
        }
    }

    void step() {
        for (int axis = 0; axis < 3; ++axis) {
            Int c = 0;
            Int e = 0;
            for (int i = 1; i <= 6; ++i) {
                c += c_[axis][i];
                e += e_[axis][i];
            }
            position_[axis] += fine(c);
            y_[axis] += mul(weight_[1], c);
            z_[axis] += mul(weight_[1], e);
            expand(axis);
        }
    }

    Int length_;
    Int sigma_ = 0;
    Int rest_ = 0;
    Int weight_[7];
    Int start_[3], n_[3], t_[3];
    Int position_[3], y_[3], z_[3];
    Int c_[3][7], e_[3][7];
};

void by_hand_samples(benchmark::State& state) {
    const std::int64_t ds = (std::int64_t(1) << (kStep + kPathFrac)) / state.range(0);
    ByHand loop(turn());
    for (auto _ : state) {
        std::int64_t fine[3];
        loop.sample(ds, fine);
        benchmark::DoNotOptimize(fine);
    }
    state.SetItemsProcessed(state.iterations());
}

/// Checks that both draw the same samples, without which the comparison is void.
bool same_samples() {
    const SegmentWords<C> segment = turn();
    InterpolatorKernel<C> kernel;
    ByHand loop(segment);
    const std::int64_t ds = (std::int64_t(1) << (kStep + kPathFrac)) / 64 - 12345;
    for (int n = 0; n < 4000; ++n) {
        Word<C::kFineBits> a[C::kAxes];
        std::int64_t b[3];
        kernel.sample(
            ds, [&]() -> const SegmentWords<C>& { return segment; }, a);
        loop.sample(ds, b);
        if (a[0] != b[0] || a[1] != b[1] || a[2] != b[2]) return false;
    }
    return true;
}

BENCHMARK(kernel_samples)->Name("kernel/samples_per_step")->Arg(64)->Arg(1);
BENCHMARK(by_hand_samples)->Name("by_hand/samples_per_step")->Arg(64)->Arg(1);

}  // namespace

int main(int argc, char** argv) {
    if (!same_samples()) {
        std::fprintf(stderr, "the kernel and the loop by hand differ\n");
        return 1;
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
