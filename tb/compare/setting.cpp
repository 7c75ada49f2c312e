// SPDX-License-Identifier: Apache-2.0
#include "tb/compare/setting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/order_words.hpp"

namespace curvecore::tb {

std::string Setting::text() const {
    return fmt::format(
        "Order={} CoefBits={} GuardBits={} Mode={} Anchor={} TurnBits={} ParameterGuard={}",
        format.order, format.coef_bits, format.guard_bits, format.polynomial ? 1 : 0,
        anchor ? 1 : 0, format.turn_bits, format.parameter_guard);
}

bool operator==(const Setting& a, const Setting& b) {
    return a.format.order == b.format.order && a.format.coef_bits == b.format.coef_bits &&
           a.format.position_bits == b.format.position_bits &&
           a.format.guard_bits == b.format.guard_bits &&
           a.format.polynomial == b.format.polynomial && a.format.turn_bits == b.format.turn_bits &&
           a.format.parameter_guard == b.format.parameter_guard && a.anchor == b.anchor;
}

ref::WordFormat widest(const ref::WordFormat& format) {
    ref::WordFormat wide = format;
    wide.coef_bits = 36;
    wide.guard_bits = 12;
    return wide;
}

MultiplierBits multiplier_bits(const Setting& setting, bool arcs, bool splines) {
    constexpr int kArcIntegrators = 6;
    constexpr int kSplineIntegrators = 16;
    const int order = setting.format.order;
    MultiplierBits cost;
    if (!setting.format.polynomial) {
        cost.sampler_products = 3 * order;
    } else {
        // tau^2, the sine's and the versine's stages, the versine's q, three products an axis.
        const int sine = (order - 1) / 2;
        const int versine = order / 2 - 1;
        cost.sampler_products = (arcs ? sine + versine + 11 : 0) + (splines ? order + 9 : 0);
    }
    cost.integrators = (arcs ? kArcIntegrators : 0) + (splines ? kSplineIntegrators : 0);
    const int width = setting.format.coef_bits;
    const int turn = setting.format.turn_bits;
    cost.bits = cost.sampler_products * width * width + cost.integrators * 18 * 18;
    for (int i = 1; i <= order && turn > 0; ++i) {
        cost.bits -=
            3 * (width * width - ref::sum_bits(width, turn, i) * ref::tau_bits(width, turn, i));
    }
    return cost;
}

}  // namespace curvecore::tb
