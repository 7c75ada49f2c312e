// SPDX-License-Identifier: Apache-2.0
// A configuration of the cores: the parameters that change words. Names and ranges are those of the
// RTL.
//
// Kernels are templates on such a format C, which they inherit: C::kOrder is a constant of the type
// here, or a value of the object where widths are known at run time only (RunTimeFormat,
// sysc/kernel/run_time_format.hpp). A format has
//
//     Coef, Fine, Position, FineParameter, Product
//                                          types of words; Product holds a sum of 13 products
//     kMostOrder, kMostAxes                constants, for arrays
//     Further, kFurtherWords               words of a table alone (hls/words.hpp): mostly none
//     note_rows(curve, rows)               called by the kernel of a table, once
//     keep(row, order, value)              called for every word that a step makes: the value as
//                                          the word keeps it
#pragma once

#include "hls/fixed_word.hpp"
#include "ref/format/parameters.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

constexpr int kMostOrder = 12;  // largest of any configuration

/// A row of a table: its words have CoefBits and so many fraction bits.
struct WordRow {
    const char* name;
    int fraction;
};

/// Further words of a segment that has none.
struct NoFurther {};

enum class SamplerMode { kSeries = 0, kPolynomial = 1 };

/// A format; ranges and meanings of its parameters: ref/format/parameters.def.
template <int Order, int CoefBits, int PositionBits, int GuardBits, int AuxAxes, SamplerMode Mode,
          bool Anchor = true, int ParameterGuard = 0>
struct Configuration {
    static_assert(ref::parameter_of(&ref::CoreParameters::order).holds(Order), "Order: its range");
    static_assert(ref::parameter_of(&ref::CoreParameters::coef_bits).holds(CoefBits),
                  "CoefBits: its range");
    static_assert(ref::parameter_of(&ref::CoreParameters::position_bits).holds(PositionBits),
                  "PositionBits: its range");
    static_assert(ref::parameter_of(&ref::CoreParameters::guard_bits).holds(GuardBits),
                  "GuardBits: its range");
    static_assert(ref::parameter_of(&ref::CoreParameters::aux_axes).holds(AuxAxes),
                  "AuxAxes: its range");
    static_assert(ref::parameter_of(&ref::CoreParameters::parameter_guard).holds(ParameterGuard),
                  "ParameterGuard: its range");

    static constexpr int kOrder = Order;
    static constexpr int kCoefBits = CoefBits;
    static constexpr int kPositionBits = PositionBits;
    static constexpr int kGuardBits = GuardBits;
    static constexpr int kAuxAxes = AuxAxes;
    static constexpr SamplerMode kMode = Mode;
    static constexpr bool kAnchor = Anchor;
    static constexpr int kParameterGuard = ParameterGuard;

    static constexpr int kAxes = 3 + AuxAxes;
    static constexpr int kFineBits = PositionBits + GuardBits;
    static constexpr int kCoefFrac = CoefBits - 2;  // coefficients and unit vectors: |x| < 2
    static constexpr int kUnitFrac = CoefBits - 1;  // tau, theta, weights: 0 <= x < 1
    static constexpr bool kSeries = Mode == SamplerMode::kSeries;
    static constexpr int kTop = Anchor ? Order - 1 : Order;  // highest phi_i that a spline needs

    static constexpr int kMostOrder = kOrder;
    static constexpr int kMostAxes = kAxes;
    static constexpr int kFurtherWords = 0;
    using Further = NoFurther;
    using Coef = Word<CoefBits>;
    using Fine = Word<kFineBits>;
    using Position = Word<PositionBits>;
    using FineParameter = Word<CoefBits + ParameterGuard>;
    using Product = Word<2 * CoefBits + 4>;

    static void note_rows(const char* /*curve*/, const WordRow* /*rows*/) {}
    static Coef keep(int /*row*/, int /*order*/, const Coef& value) { return value; }
};

using DefaultConfiguration = Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries>;
using DefaultSplineConfiguration = Configuration<6, 36, 32, 10, 0, SamplerMode::kPolynomial>;

/// Formats that no parameter changes; the planner knows some of them too.
using ref::kBusLengthBits;
using ref::kMaxStepExponent;
using ref::kPathFrac;
using ref::kProfileBusWords;
constexpr int kLengthBits = 48;  // path lengths inside the core, in quanta
constexpr int kPathBits = 64;    // program-wide path length, in quanta
constexpr int kBusBits = 48;     // one word of the segment and profile streams

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
