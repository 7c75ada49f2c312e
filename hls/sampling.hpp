// SPDX-License-Identifier: Apache-2.0
// Path to tau, and displacement to position: the common part of all curves' samplers.
// Twins: rtl/sampler/sample_offset.sv, rtl/arithmetic/fine_scale.sv.
#pragma once

#include "hls/words.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// Converts displacement d (CoefBits, in units of 2^k) to a position word with GuardBits fraction
/// bits.
template <class C>
inline typename C::Fine to_fine(const C& c, const typename C::Coef& d, int k) {
    const int top = kMaxStepExponent + c.kGuardBits - c.kCoefFrac;
    const int left = top > 0 ? top : 0;
    const Word<64> wide = Word<64>(d) * (1 << left);
    return typename C::Fine(round_shift(wide, left - top + kMaxStepExponent - k));
}

/// Returns tau of an offset sigma (quanta, 0 <= sigma <= 2^(k+16)) into a step: the low bits, cut
/// to CoefBits-1. An offset of a full step gives 0: the lander draws that point.
template <class C>
inline typename C::Coef to_tau(const C& c, const Word<kLengthBits + 1>& sigma, int k) {
    constexpr int kStepBits = kMaxStepExponent + kPathFrac;
    const Word<kStepBits + 2> aligned = Word<kStepBits + 2>(sigma) << (kMaxStepExponent - k);
    const Word<kStepBits + 2> fraction =
        aligned & Word<kStepBits + 2>((Word<kStepBits + 2>(1) << kStepBits) - 1);
    return typename C::Coef(fraction >> (kStepBits - c.kUnitFrac));
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
