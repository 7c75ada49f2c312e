// SPDX-License-Identifier: Apache-2.0
// The exact part of the cost model.
#pragma once

#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

int count_dsp(Core core, const CoreParameters& parameters, const Device& device);
/// Pairs of bits, one of each operand, that LUTs multiply in the serial build's multiplier.
int soft_bits(const CoreParameters& parameters, const Device& device);
/// Returns true if the multiplier takes blocks of more than 18 x 18 bits, which are slower.
bool wide_block(const CoreParameters& parameters, const Device& device);
int count_ram(Core core, const CoreParameters& parameters, const Device& device);

}  // namespace curvecore::sysc
