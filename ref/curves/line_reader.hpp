// SPDX-License-Identifier: Apache-2.0
// One line of a curve's table (ref/curves/curve_table.hpp) as text.
#pragma once

#include <string>

#include "ref/curves/curve_table.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

/// Reads `ROW : FRACTION = TERM + ..`; what its rows are is not looked at.
/// @throws InputError if it is no line
TableLine read_table_line(const std::string& text, const Place& place);

/// Reads a row: NAME, NAME[k], NAME', NAME.2. @throws InputError
RowOperand read_row_operand(const std::string& text, const Place& place);

}  // namespace curvecore::ref
