// SPDX-License-Identifier: Apache-2.0
// A plan as the words that the bus and the memory files carry, for any legal configuration.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/curve/segment.hpp"
#include "sysc/host/core_parameters.hpp"

namespace curvecore::sysc {

/// The words (hls/words.hpp) of the plan's segment `index`.
std::vector<std::uint64_t> segment_bus_words(const ref::Segment& segment, std::size_t index,
                                             const CoreParameters& parameters);

/// Words of 48 bits of the plan's piece `index`, number so and so of the program: of the branch
/// before it, if there is one, and five.
std::vector<std::uint64_t> profile_bus_words(const ref::Plan& plan, std::size_t index,
                                             std::size_t number);

}  // namespace curvecore::sysc
