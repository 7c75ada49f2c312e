// SPDX-License-Identifier: Apache-2.0
// Schemes by which `curvecore compare` draws splines.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// | scheme     | draws                                                       | in words, double |
/// |------------|-------------------------------------------------------------|------------------|
/// | anchored   | our segments and steps, Anchor 1                            | words            |
/// | propagated | our segments and steps, Anchor 0                            | words            |
/// | paper      | [Chikurov]: one integration a tick over the whole cubic,    | both             |
/// |            | its end value only, all sixteen variables carried           |                  |
/// | rk4        | the sixteen variables by Runge-Kutta, once a tick           | double           |
/// | scalar     | du/ds = 1 / |V(u)| by Runge-Kutta, once a tick              | double           |
enum class Scheme { kAnchored, kPropagated, kPaper, kRungeKutta, kScalar };
constexpr std::array<std::string_view, 5> kSchemeNames{"anchored", "propagated", "paper", "rk4",
                                                       "scalar"};

/// A scheme that steps once a tick, by feed times tick along the path.
///
/// | field | unit | meaning                                                      |
/// |-------|------|--------------------------------------------------------------|
/// | words |      | paper: in the configuration's words; otherwise in double     |
/// | tick  | s    |                                                              |
/// | feed  | mm/s |                                                              |
struct TickScheme {
    Scheme scheme = Scheme::kPaper;
    bool words = false;
    double tick = 0;
    double feed = 0;

    double step() const { return tick * feed; }  // mm
    /// Returns false for Runge-Kutta, which has neither Order nor words.
    bool has_order() const { return scheme == Scheme::kPaper; }
    bool uses(const ref::Parameter& one) const {
        return (one.value == &CoreParameters::order && has_order()) ||
               (one.value == &CoreParameters::coef_bits && words);
    }
};

inline bool is_ticked(Scheme scheme) { return scheme >= Scheme::kPaper; }

inline std::string scheme_name(Scheme scheme) {
    return std::string(kSchemeNames[static_cast<std::size_t>(scheme)]);
}

}  // namespace curvecore::sysc
