// SPDX-License-Identifier: Apache-2.0
// Cells of a line of a .csv file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace curvecore::ref {

/// Trims spaces and tabs at both ends.
std::string_view trim(std::string_view text);

/// Returns the line's cells, trimmed; a line without a separator is one cell.
std::vector<std::string_view> cells_of(std::string_view line, char separator = ',');
/// Splits at commas; without one at semicolons; without these at blanks and tabs.
std::vector<std::string_view> columns_of(std::string_view line);

/// Returns a cell for a message: printable, not too long.
std::string shown(std::string_view cell);

/// Returns the number that the whole cell is; also inf and nan.
std::optional<double> cell_number(std::string_view cell);

}  // namespace curvecore::ref
