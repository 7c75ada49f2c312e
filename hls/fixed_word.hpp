// SPDX-License-Identifier: Apache-2.0
// Words and their one rounding. Twin: rtl/curvecore_pkg.sv, rtl/arithmetic/.
//
// A word is a two's complement integer; its user's comment states its format, hls/storage.hpp its
// storage.
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
inline std::int64_t to_int(const ac_int<Bits, true>& word) {
    return word.to_int64();
}
#elif defined(CURVECORE_AP_INT)
template <int Bits>
using Word = ap_int<Bits>;
template <int Bits>
inline std::int64_t to_int(const ap_int<Bits>& word) {
    return word.to_int64();
}
#elif defined(CURVECORE_BIT_INT)
template <int Bits>
using Word = _BitInt(Bits > 64 ? 128 : Bits);
template <int Bits>
inline std::int64_t to_int(_BitInt(Bits) word) {
    return static_cast<std::int64_t>(word);
}
#elif defined(CURVECORE_CHECKED)
__extension__ using Wide = __int128;

/// A word with the arithmetic of a wide integer; values put into it must fit.
template <int Bits>
class Word {
  public:
    Word() = default;
    /// @throws std::range_error if the value does not fit
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
inline std::int64_t to_int(std::int64_t word) { return word; }
#endif

/// Returns floor(value / 2^shift + 1/2): to nearest, ties towards +infinity. No other rounding
/// exists. The word holds 2^shift and the sum.
template <class T>
inline T round_shift(const T& value, int shift) {
    return T((value + ((T(1) << shift) >> 1)) >> shift);
}

/// Returns a full product, in a word that holds it, rounded once.
template <class Product, class T>
inline T rounded_product(const T& a, const T& b, int shift) {
    return T(round_shift(Product(Product(a) * Product(b)), shift));
}

/// Returns round(2^frac / i): the constants of Riemann's weights.
constexpr std::int64_t reciprocal(int i, int frac) {
    return ((std::int64_t(1) << (frac + 1)) / i + 1) / 2;
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
