// SPDX-License-Identifier: Apache-2.0
// Cells of a line of a .csv file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace curvecore::ref {

/// Without spaces and tabs at both ends.
std::string_view trim(std::string_view text);

/// The line's cells, trimmed; a line without a separator is one cell.
std::vector<std::string_view> cells_of(std::string_view line, char separator = ',');
/// Between commas; without one between semicolons; without these between blanks and tabs.
std::vector<std::string_view> columns_of(std::string_view line);

/// A cell as a message may show it: printable, not too long.
std::string shown(std::string_view cell);

/// The number that the whole cell is; also inf and nan.
std::optional<double> cell_number(std::string_view cell);

}  // namespace curvecore::ref
