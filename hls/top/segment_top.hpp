// SPDX-License-Identifier: Apache-2.0
// A kernel of segments as a function without a state, for an HLS compiler: every call loads the
// segment, makes CFG_Steps integration steps and draws one sample of the last.
//
//     words    the segment as the bus carries it (hls/words.hpp)
//     sigma    offset into the step, in quanta: 0 .. 2^(k + 16)
//     fine     fine position, axis by axis
#pragma once

#include "hls/top/top_configuration.hpp"
#include "hls/words.hpp"

namespace curvecore {
namespace hls {

template <class C>
using SegmentFrame = unsigned _BitInt(kBusBits)[17 + 3 * C::kAuxAxes + C::kFurtherWords];
using FinePosition = TopConfiguration::Fine[TopConfiguration::kAxes];

template <class Kernel, class C = TopConfiguration>
inline void draw_sample(const SegmentFrame<C>& words, const Word<kLengthBits + 1>& sigma,
                        FinePosition& fine) {
    const auto* word = words;
    Kernel kernel;
    kernel.load(unpack_segment<C>([&] { return std::uint64_t(*word++); }));
    for (int step = 0; step < CFG_Steps; ++step) {
        kernel.step();
    }
    FinePosition drawn;  // not in place: the compiler could reuse the inputs
    kernel.sample(sigma, drawn);
    for (int axis = 0; axis < TopConfiguration::kAxes; ++axis) {
        fine[axis] = drawn[axis];
    }
}

}  // namespace hls
}  // namespace curvecore
