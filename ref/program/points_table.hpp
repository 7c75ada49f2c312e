// SPDX-License-Identifier: Apache-2.0
// The numbers of a file of points; knows columns and cells, not their purpose.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ref/gcode/blocks/block.hpp"

namespace curvecore::ref {

/// Columns in the order of `kPointColumns`, whatever their order in the file.
constexpr std::string_view kPointColumns[] = {"x", "y",  "z",  "a",  "b",   "c",   "u",  "v",
                                              "w", "dx", "dy", "dz", "ddx", "ddy", "ddz"};
constexpr int kPointColumnCount = 15;
constexpr int kFirstD1 = 9;  // dx
constexpr int kFirstD2 = 12;

struct PointRow {
    int line = 0;
    std::array<std::optional<double>, kPointColumnCount> cell;
};

struct PointTable {
    int header_line = 0;  // 0: there is none
    std::array<bool, kPointColumnCount> has{};
    std::vector<PointRow> rows;
};

/// Reads the table. A missing column z is 0. Positions and auxiliary axes stand in every row and
/// lie within
/// kFarthest; a derivative stands for all three axes or none.
/// @throws InputError: unknown, missing or doubled columns, ragged rows, invalid numbers
PointTable read_point_table(std::string_view text, const std::string& file_name);

}  // namespace curvecore::ref
