// SPDX-License-Identifier: Apache-2.0
// A curve's table as programs of the engine: `NAME load` opens a segment, `NAME step` goes on to
// the next step, `NAME sample` draws one.
//
// A segment's words are there before: theta, tangent[k], normal[k], advance[k], start[k] by the
// names of hls/words.hpp, of auxiliary axes advance[3] and start[3] on; and `k`, `s`, whose powers
// of two load makes. A sample reads `sigma` and writes fine[k], fine[3] ..
#pragma once

#include <map>
#include <string>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Adds the programs; behind load and step they go on at `after_step`, behind a sample at
/// `after_sample`. Returns the word of each value that is kept, by its name.
/// @throws AssemblyError
std::map<std::string, std::string> assemble_curve(const ref::CurveTable& table,
                                                  const ref::CoreParameters& core,
                                                  Assembly& assembly, const std::string& after_step,
                                                  const std::string& after_sample);

}  // namespace curvecore::assembler
