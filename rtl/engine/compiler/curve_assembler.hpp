// SPDX-License-Identifier: Apache-2.0
// Tables of curves as programs of the engine: `curve_load` opens a segment, `curve_step` goes on to
// the next step, `curve_sample` draws one; of a curve alone NAME_load, NAME_step, NAME_sample.
//
// A segment's words are there before: `kind`, 0 of the first curve, 1 of splines, negative of the
// core's further table, which is the last one; theta,
// tangent[k], normal[k], advance[k], start[k] by the names of hls/words.hpp, of auxiliary axes
// advance[3] and start[3] on; and its scales, of load on: tau_scale = 2^(27-k), fine_scale =
// 2^(fine+k), place_scale = 2^(fine+lambda), step_scale = 2^(44-s), s = lambda - k. A sample reads
// `sigma` and writes fine[k], fine[3] .., which a step and a load destroy.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// The word of each value of a curve, by the value's name.
using CurveWords = std::map<std::string, std::string>;

/// Adds the programs of curves; behind load and step they go on at `after_step`, behind a sample at
/// `after_sample`. They keep no link. @throws AssemblyError
std::vector<CurveWords> assemble_curves(const std::vector<ref::CurveTable>& tables,
                                        const ref::CoreParameters& core, Assembly& assembly,
                                        const std::string& after_step,
                                        const std::string& after_sample);

/// Assembles one curve alone, in the largest store; behind its programs is `idle`, an instruction.
/// @throws AssemblyError
Assembly curve_program(const ref::CurveTable& table, const ref::CoreParameters& core);

}  // namespace curvecore::assembler
