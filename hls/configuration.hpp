// SPDX-License-Identifier: Apache-2.0
// A configuration of the cores: the parameters that change words. Same names and ranges as the RTL.
#pragma once

#include "ref/order_words.hpp"

namespace curvecore {
namespace hls {

enum class SamplerMode { kSeries = 0, kPolynomial = 1 };

/// | parameter      | range    | meaning                                                       |
/// |----------------|----------|---------------------------------------------------------------|
/// | Order          | 2 .. 12  | highest power of the series                                   |
/// | CoefBits       | 18 .. 36 | coefficients, weights, tau, unit vectors: every multiplier    |
/// |                |          | word                                                          |
/// | PositionBits   | 16 .. 32 | positions in whole length units                               |
/// | GuardBits      | 2 .. 12  | fraction bits below the length unit inside the core           |
/// | AuxAxes        | 0 .. 6   | auxiliary linear axes                                         |
/// | Anchor         | 0, 1     | splines: V W P from the polynomial at every step (1), or      |
/// |                |          | every variable propagated by its series as the paper does (0) |
/// | TurnBits       | 0 .. 14  | 0: all orders of CoefBits. Else arcs in series mode only, so  |
/// |                |          | short steps that they turn by at most 2^-TurnBits rad:        |
/// |                |          | ref/order_words.hpp                                           |
/// | ParameterGuard | 0 .. 8   | splines: fraction bits of the parameter below those of tau,   |
/// |                |          | in which it adds up from step to step; products have it       |
/// |                |          | rounded                                                       |
template <int Order, int CoefBits, int PositionBits, int GuardBits, int AuxAxes, SamplerMode Mode,
          bool Anchor = true, int TurnBits = 0, int ParameterGuard = 0>
struct Configuration {
    static_assert(Order >= 2 && Order <= 12, "Order must be in [2, 12]");
    static_assert(CoefBits >= 18 && CoefBits <= 36, "CoefBits must be in [18, 36]");
    static_assert(PositionBits >= 16 && PositionBits <= 32, "PositionBits must be in [16, 32]");
    static_assert(GuardBits >= 2 && GuardBits <= 12, "GuardBits must be in [2, 12]");
    static_assert(AuxAxes >= 0 && AuxAxes <= 6, "AuxAxes must be in [0, 6]");
    static_assert(TurnBits >= 0 && TurnBits <= 14, "TurnBits must be in [0, 14]");
    static_assert(TurnBits == 0 || Mode == SamplerMode::kSeries, "TurnBits needs series mode");
    static_assert(ParameterGuard >= 0 && ParameterGuard <= 8, "ParameterGuard must be in [0, 8]");

    static constexpr int kOrder = Order;
    static constexpr int kCoefBits = CoefBits;
    static constexpr int kPositionBits = PositionBits;
    static constexpr int kGuardBits = GuardBits;
    static constexpr int kAuxAxes = AuxAxes;
    static constexpr SamplerMode kMode = Mode;
    static constexpr bool kAnchor = Anchor;
    static constexpr int kTurnBits = TurnBits;
    static constexpr int kParameterGuard = ParameterGuard;

    static constexpr int kAxes = 3 + AuxAxes;
    static constexpr int kFineBits = PositionBits + GuardBits;
    static constexpr int kCoefFrac = CoefBits - 2;  // coefficients and unit vectors: |x| < 2
    static constexpr int kUnitFrac = CoefBits - 1;  // tau, theta, weights: 0 <= x < 1
};

using DefaultConfiguration = Configuration<6, 36, 32, 10, 0, SamplerMode::kSeries>;
using DefaultSplineConfiguration = Configuration<6, 36, 32, 10, 0, SamplerMode::kPolynomial>;

/// Formats that no parameter changes.
constexpr int kPathFrac = 16;         // a path quantum is 2^-16 length unit
constexpr int kMaxStepExponent = 27;  // an integration step is 2^k length units, k in [0, 27]
constexpr int kLengthBits = 48;       // a segment's length, in quanta
constexpr int kPathBits = 64;         // program-wide path length, in quanta
constexpr int kBusBits = 48;          // one word of the segment and profile streams

}  // namespace hls
}  // namespace curvecore
