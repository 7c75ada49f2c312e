// SPDX-License-Identifier: Apache-2.0
// A file of a curve's table: ref/curves/curve_table.hpp says what its lines mean.
//
//     curve NAME title         word NAME[3] FRACTION ..      start NAME[3] FRACTION ..
//     const NAME FRACTION VALUE          output NAME         polished NAME ..
//     guard NAME ..            rows that `next` makes with ParameterGuard fraction bits more
//     alias Dq phi'            a rate that is another row, an order lower
//     bus FIELD NAME ..        where the words come from: theta tangent normal advance, and what
//                              needs more from further.0, further.1 ..
//     power NAME N             how a row grows with the step, where no line says it
#pragma once

#include <string>

#include "ref/curves/curve_table.hpp"

namespace curvecore::ref {

/// @throws InputError with file, line and reason
CurveTable read_curve_table(const std::string& file);

/// Reads a table from text; `file` names it in errors.
CurveTable read_curve_text(const std::string& file, const std::string& text);

/// The same of a table that may be a network alone: without a bus and an output, its words and
/// start values are given.
CurveTable read_network_text(const std::string& file, const std::string& text);

}  // namespace curvecore::ref
