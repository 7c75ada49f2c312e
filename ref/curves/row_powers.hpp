// SPDX-License-Identifier: Apache-2.0
// Powers of the step in the rows of a table: what a segment in other steps, or a curve in other
// units, has in its words.
#pragma once

#include <map>
#include <string>

#include "ref/curves/curve_table.hpp"

namespace curvecore::ref {

/// Returns the power p of the step h in each row of the bus: its value is c h^p, where c is the
/// curve's alone, in 1 / length^p. It follows from the lines of `anchor` and `order`: both sides of
/// each grow alike, order i of a row with h^(p + i), and the output, a part of the step, with p =
/// -1; and from what the table says.
/// @throws InputError of such a line whose terms cannot all grow alike, or that meets series order
/// by order; of any line that scales by s, whose powers are not derived; of a row whose power is
/// open
std::map<std::string, int> row_powers(const CurveTable& table);

}  // namespace curvecore::ref
