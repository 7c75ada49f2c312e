// SPDX-License-Identifier: Apache-2.0
// Words and the one rounding. Twin: rtl/curvecore_pkg.sv, rtl/arithmetic/.
//
// A word is a two's complement integer; its format is in its user's comment, its storage that of
// hls/storage.hpp.
#pragma once

#include <cstdint>

#include "hls/storage.hpp"

#if defined(CURVECORE_AC_INT)
#include <ac_int.h>
#elif defined(CURVECORE_AP_INT)
#include <ap_int.h>
#elif defined(CURVECORE_CHECKED)
#include <stdexcept>
#include <string>
#endif

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

#if defined(CURVECORE_AC_INT)
template <int Bits>
using Word = ac_int<Bits, true>;
template <int Bits>
inline std::int64_t to_int(const Word<Bits>& word) {
    return word.to_int64();
}
#elif defined(CURVECORE_AP_INT)
template <int Bits>
using Word = ap_int<Bits>;
template <int Bits>
inline std::int64_t to_int(const Word<Bits>& word) {
    return word.to_int64();
}
#elif defined(CURVECORE_CHECKED)
__extension__ using Wide = __int128;

/// Arithmetic is that of a wide integer; what is put into a word must fit.
template <int Bits>
class Word {
  public:
    Word() = default;
    /// @throws std::range_error
    Word(Wide value) : value_(value) {
        const Wide limit = Wide(1) << (Bits - 1);
        if (value < -limit || value >= limit) {
            throw std::range_error("a value needs more than the " + std::to_string(Bits) +
                                   " bits of its word");
        }
    }
    operator Wide() const { return value_; }

  private:
    Wide value_ = 0;
};
template <int Bits>
inline std::int64_t to_int(const Word<Bits>& word) {
    return static_cast<std::int64_t>(static_cast<Wide>(word));
}
#else
namespace detail {
template <bool Wide>
struct Native {
    using Type = std::int64_t;
};
template <>
struct Native<true> {
    __extension__ using Type = __int128;
};
}  // namespace detail
template <int Bits>
using Word = typename detail::Native<(Bits > 64)>::Type;
template <int Bits>
inline std::int64_t to_int(Word<Bits> word) {
    return static_cast<std::int64_t>(word);
}
#endif

/// floor(value / 2^Shift + 1/2): to nearest, ties towards +infinity. The only rounding there is.
template <int Bits, int Shift>
inline Word<Bits> round_shift(const Word<Bits>& value) {
    static_assert(Shift >= 0 && Shift < Bits, "shift must be shorter than the word");
    const Word<Bits> half =
        Shift > 0 ? Word<Bits>(Word<Bits>(1) << (Shift > 0 ? Shift - 1 : 0)) : Word<Bits>(0);
    return Word<Bits>((value + half) >> Shift);
}

/// The same with a shift known only at run time, 0 <= shift < Bits: two exact floors, as in the
/// RTL.
template <int Bits>
inline Word<Bits> round_shift(const Word<Bits>& value, int shift) {
    const Word<Bits + 2> doubled = Word<Bits + 2>(value) * 2;
    return Word<Bits>((Word<Bits + 2>(doubled >> shift) + 1) >> 1);
}

/// Full product of two words, rounded once.
template <int Bits, int Shift>
inline Word<Bits> rounded_product(const Word<Bits>& a, const Word<Bits>& b) {
    const Word<2 * Bits> product = Word<2 * Bits>(a) * Word<2 * Bits>(b);
    return Word<Bits>(round_shift<2 * Bits, Shift>(product));
}

/// round(2^Frac / i): the constants of Riemann's weights.
template <int Frac>
constexpr std::int64_t reciprocal(int i) {
    return ((std::int64_t(1) << (Frac + 1)) / i + 1) / 2;
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
