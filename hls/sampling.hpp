// SPDX-License-Identifier: Apache-2.0
// From path to tau, and from a displacement to a position: what all curves' samplers share.
// Twins: rtl/sampler/sample_offset.sv, rtl/arithmetic/fine_scale.sv.
#pragma once

#include "hls/words.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// Displacement d (CoefBits, in units of 2^k) as a position word with GuardBits fraction bits.
template <class C>
inline Word<C::kFineBits> to_fine(const Word<C::kCoefBits>& d, int k) {
    constexpr int kTop = kMaxStepExponent + C::kGuardBits - C::kCoefFrac;
    constexpr int kLeft = kTop > 0 ? kTop : 0;
    constexpr int kRight = kTop > 0 ? 0 : -kTop;
    const Word<C::kCoefBits + kLeft> wide = Word<C::kCoefBits + kLeft>(d) * (1 << kLeft);
    return Word<C::kFineBits>(
        round_shift<C::kCoefBits + kLeft>(wide, kRight + kMaxStepExponent - k));
}

/// tau of an offset sigma (quanta, 0 <= sigma <= 2^(k+16)) into a step: the low bits, cut to
/// CoefBits-1. An offset of a full step gives 0: the lander draws that point.
template <class C>
inline Word<C::kCoefBits> to_tau(const Word<kLengthBits + 1>& sigma, int k) {
    constexpr int kStepBits = kMaxStepExponent + kPathFrac;
    const Word<kStepBits + 2> aligned = Word<kStepBits + 2>(sigma) << (kMaxStepExponent - k);
    const Word<kStepBits + 2> fraction =
        aligned & Word<kStepBits + 2>((Word<kStepBits + 2>(1) << kStepBits) - 1);
    return Word<C::kCoefBits>(fraction >> (kStepBits - C::kUnitFrac));
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
