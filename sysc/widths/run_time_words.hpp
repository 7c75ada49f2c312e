// SPDX-License-Identifier: Apache-2.0
// hls/fixed_word.hpp, hls/sampling.hpp and hls/series_node.hpp with widths that are known at run
// time only: native integers, the same roundings, held equal by tb/model/run_time_kernel_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "hls/configuration.hpp"
#include "hls/fixed_word.hpp"
#include "sysc/host/core_parameters.hpp"

namespace curvecore::sysc {

using RunWord = std::int64_t;
using RunProduct = hls::Word<128>;  // of two words, and sums of those

constexpr int kMostOrders = 13;  // 0 .. 12
constexpr int kMostAxes = 9;

/// floor(value / 2^bits + 1/2); bits >= 0.
class Rounding {
  public:
    explicit Rounding(int bits = 0) : bits_(bits), half_(bits > 0 ? RunWord(1) << (bits - 1) : 0) {}

    RunWord operator()(RunProduct value) const {
        return static_cast<RunWord>((value + half_) >> bits_);
    }
    RunWord product(RunWord a, RunWord b) const { return (*this)(RunProduct(a) * b); }

  private:
    int bits_;
    RunWord half_;
};

/// A two's complement word of so many bits, as a register keeps it: what does not fit is cut off.
inline RunWord wrapped(RunWord value, int bits) {
    const int left = 64 - bits;
    return static_cast<RunWord>(static_cast<std::uint64_t>(value) << left) >> left;
}

/// hls::scaled_down.
inline RunWord scaled_down(RunWord x, int lift, int shift) {
    return ((x * (RunWord(1) << (lift + 1)) >> shift) + 1) >> 1;
}

/// The shift from a displacement in units of 2^k to a fine position, hls::to_fine.
class FineShift {
  public:
    FineShift() = default;
    FineShift(const CoreParameters& format, int k) {
        const int top = hls::kMaxStepExponent + format.guard_bits - (format.coef_bits - 2);
        left_ = top > 0 ? top : 0;
        right_ = (top > 0 ? 0 : -top) + hls::kMaxStepExponent - k;
        half_ = right_ > 0 ? RunWord(1) << (right_ - 1) : 0;
    }
    RunWord operator()(RunWord d) const { return (d * (RunWord(1) << left_) + half_) >> right_; }

  private:
    int left_ = 0;
    int right_ = 0;
    RunWord half_ = 0;
};

/// tau of an offset into a step of 2^k units, hls::to_tau.
inline RunWord to_tau(RunWord sigma, int k, int coef_bits) {
    constexpr int kStepBits = hls::kMaxStepExponent + hls::kPathFrac;
    const RunWord aligned = sigma << (hls::kMaxStepExponent - k);
    return (aligned & ((RunWord(1) << kStepBits) - 1)) >> (kStepBits - (coef_bits - 1));
}

/// round(2^frac / i), hls::reciprocal.
inline RunWord reciprocal(int i, int frac) { return ((RunWord(1) << (frac + 1)) / i + 1) / 2; }

/// Sum of u[j] ds[i - j], j in [0, i): hls::convolve before its rounding.
inline RunProduct convolved(const RunWord* u, const RunWord* ds, int i) {
    RunProduct sum = 0;
    for (int j = 0; j < i; ++j) sum += RunProduct(u[j]) * ds[i - j];
    return sum;
}

}  // namespace curvecore::sysc
