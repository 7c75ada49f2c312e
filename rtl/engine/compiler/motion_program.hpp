// SPDX-License-Identifier: Apache-2.0
// All programs of Build 2 of rtl/motion_interpolator.sv: curves of their tables, and the text in
// rtl/engine/programs/.
#pragma once

#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Words of 48 bits that the queues hold: SegmentQueueWords, ProfileQueueWords.
struct QueueWords {
    int segments = 4096;
    int profile = 4096;
};

/// Returns the store of a core's parameters, as rtl/motion_interpolator.sv has it.
StoreSize motion_store(const ref::CoreParameters& core);

/// Assembles the motion of a core; `tree` is the folder that has ref/curves and rtl/engine. Its
/// samples are fine positions, or with rate_bits rates of so many bits: motion_system's.
/// @throws AssemblyError
Assembly motion_program(const ref::CoreParameters& core, const QueueWords& queues,
                        const std::string& tree, int rate_bits = 0);

/// The same of other curves: that of arcs' segments, and that of splines', if the core has them.
Assembly motion_program(const std::vector<ref::CurveTable>& tables, const ref::CoreParameters& core,
                        const QueueWords& queues, const std::string& tree, int rate_bits = 0);

}  // namespace curvecore::assembler
