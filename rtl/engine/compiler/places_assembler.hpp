// SPDX-License-Identifier: Apache-2.0
// Programs that put out samples as rates of the axes: rtl/engine/programs/places.asm.
#pragma once

#include <string>

#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Bits of a rate, at most: what is left of an entry of rtl/engine/engine_rates.sv.
constexpr int kMostRateBits = 29;

/// Adds them; `programs` is the folder of the text.
void assemble_places(const std::string& programs, const ref::CoreParameters& core, int rate_bits,
                     Assembly& assembly);

}  // namespace curvecore::assembler
