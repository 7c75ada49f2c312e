// SPDX-License-Identifier: Apache-2.0
// A plan as the words that the bus and the memory files carry, for any legal configuration.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/plan/segment.hpp"
#include "tb/command/core_parameters.hpp"

namespace curvecore::tb {

/// 17 + 3 AuxAxes words of 48 bits (hls/words.hpp).
std::vector<std::uint64_t> segment_bus_words(const ref::Segment& segment,
                                             const CoreParameters& parameters);

/// Five words of 48 bits.
std::vector<std::uint64_t> profile_bus_words(const ref::ProfilePiece& piece);

}  // namespace curvecore::tb
