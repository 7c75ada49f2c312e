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

/// Returns the store of a core's parameters, as rtl/motion_interpolator.sv has it; of one that has
/// a table, with a Table.
StoreSize motion_store(const ref::CoreParameters& core);

/// Assembles the motion of a core; `tree` is the folder that has ref/curves and rtl/engine. Its
/// samples are fine positions, or with rate_bits rates of so many bits: motion_system's.
/// @throws AssemblyError
Assembly motion_program(const ref::CoreParameters& core, const QueueWords& queues,
                        const std::string& tree, int rate_bits = 0);

/// The same of other curves: that of arcs' segments, that of splines' if the core has them, and of
/// tables' if it has one.
Assembly motion_program(const std::vector<ref::CurveTable>& tables, const ref::CoreParameters& core,
                        const QueueWords& queues, const std::string& tree, int rate_bits = 0);

/// Assembles what comes behind the axes' words of a segment: the table's own, or nothing.
void assemble_table_words(const std::string& programs, const ref::CoreParameters& core,
                          Assembly& assembly);

}  // namespace curvecore::assembler
