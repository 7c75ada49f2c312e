// SPDX-License-Identifier: Apache-2.0
// Programs that draw samples of a stream of segments: programs/follow.asm and segment.asm, those of
// the curves and of the auxiliary axes.
#pragma once

#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Adds them. Names `segment_begin` and `segment_end`, places of the queue, and those of ports.asm
/// are defined before; `programs`: the folder of the sources; `tables`: arcs, or arcs and splines.
/// @throws AssemblyError, ref::InputError
void assemble_follow(const std::string& programs, const std::vector<ref::CurveTable>& tables,
                     const ref::CoreParameters& core, Assembly& assembly);

}  // namespace curvecore::assembler
