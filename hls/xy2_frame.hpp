// SPDX-License-Identifier: Apache-2.0
// A position in the frame of a scan head, XY2-100. Twin: rtl/pulse/xy2_100.sv, which explains it.
#pragma once

#include <cstdint>

namespace curvecore {
namespace hls {

/// Returns a frame of 20 bits, the first one on top, for a position of `fine_bits`.
inline std::uint32_t xy2_frame(std::int64_t position, int fine_bits) {
    const std::int64_t half = std::int64_t(1) << (fine_bits - 17);
    std::int64_t rounded = (position + half) >> (fine_bits - 16);
    if (rounded > 0x7fff) rounded = 0x7fff;
    std::uint32_t frame = (1U << 17) | static_cast<std::uint32_t>(rounded + 0x8000) << 1;
    for (int bit = 1; bit < 20; ++bit) frame ^= frame >> bit & 1U;
    return frame;
}

}  // namespace hls
}  // namespace curvecore
