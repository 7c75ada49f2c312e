// SPDX-License-Identifier: Apache-2.0
// Words of register SHAPER for a machine's taps (rtl/pulse/input_shaper.sv, way_delay.sv).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hls/input_shaper.hpp"
#include "hls/registers/registers.h"
#include "ref/machine/shaper.hpp"

namespace curvecore::sysc {

/// @param tool_delay samples by which outputs are late
inline std::vector<std::uint32_t> shaper_words(
    const std::array<ref::ShaperTaps, ref::kMachineAxes>& taps, int axes, int tool_delay) {
    std::vector<std::uint32_t> words;
    const auto add = [&](int kind, int axis, double value) {
        const auto word = static_cast<std::uint32_t>(std::lround(value));
        words.push_back(CURVECORE_PUT(SHAPER_KIND, kind) | CURVECORE_PUT(SHAPER_AXIS, axis) |
                        (word & CURVECORE_SHAPER_VALUE_MASK));
    };
    for (int axis = 0; axis < axes; ++axis) {
        const ref::ShaperTaps& own = taps[static_cast<std::size_t>(axis)];
        add(0, axis, own.delay);
        add(1, axis, std::ldexp(own.near, hls::kGainFrac));
        add(2, axis, std::ldexp(own.far, hls::kGainFrac));
    }
    add(3, 0, tool_delay);
    return words;
}

}  // namespace curvecore::sysc
