// SPDX-License-Identifier: Apache-2.0
#include "ref/program/points_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/text/csv_cells.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

constexpr double kLargestDerivative = 1e9;

class Reader {
  public:
    explicit Reader(const std::string& file) : file_(file) {}

    PointTable read(std::string_view text) {
        std::istringstream stream{std::string(text)};
        TextLines lines(stream);
        while (const std::optional<std::string_view> line = lines.next()) {
            const std::string_view content = trim(line->substr(0, line->find('#')));
            if (content.empty()) continue;
            const Place place{file_, lines.number()};
            const std::vector<std::string_view> cells = columns_of(content);
            if (order_.empty() && is_name(cells[0])) {
                table_.header_line = place.line;
                read_header(cells, place);
                continue;
            }
            if (order_.empty()) assume_columns(cells.size(), place);
            read_row(cells, place);
        }
        return std::move(table_);
    }

  private:
    /// Returns true for a name; inf and nan are neither numbers nor names here.
    static bool is_name(std::string_view cell) {
        return !cell.empty() && std::isalpha(static_cast<unsigned char>(cell[0])) != 0 &&
               !cell_number(cell);
    }

    void read_header(const std::vector<std::string_view>& cells, const Place& place) {
        for (const std::string_view cell : cells) {
            std::string name(cell);
            std::transform(name.begin(), name.end(), name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            const auto* found = std::find(std::begin(kPointColumns), std::end(kPointColumns), name);
            if (found == std::end(kPointColumns)) {
                place.refuse(fmt::format("no such column: '{}' (there are {})", shown(cell),
                                         fmt::join(kPointColumns, " ")));
            }
            add_column(static_cast<int>(found - std::begin(kPointColumns)), place);
        }
        for (const int first : {0, kFirstD1, kFirstD2}) {
            const int given = table_.has[first] + table_.has[first + 1] + table_.has[first + 2];
            const bool flat = first == 0 && given == 2 && !table_.has[2];
            if (given < 3 && !flat && (given > 0 || first == 0)) {
                const auto* missing = std::find(&table_.has[first], &table_.has[first] + 3, false);
                place.refuse(fmt::format("the column {} is missing",
                                         kPointColumns[missing - &table_.has[0]]));
            }
        }
    }

    void assume_columns(std::size_t count, const Place& place) {
        if (count < 2 || count > kFirstD1) {
            place.refuse(
                fmt::format("{} numbers: without a header there are 2 (x y) to {} (x y "
                            "z a b c u v w)",
                            count, kFirstD1));
        }
        for (std::size_t i = 0; i < count; ++i) add_column(static_cast<int>(i), place);
    }

    void add_column(int column, const Place& place) {
        if (table_.has[column]) {
            place.refuse(fmt::format("the column {} stands twice", kPointColumns[column]));
        }
        table_.has[column] = true;
        order_.push_back(column);
        if (order_.size() == 1) first_line_ = place.line;
    }

    void read_row(const std::vector<std::string_view>& cells, const Place& place) {
        if (cells.size() != order_.size()) {
            place.refuse(fmt::format("{} cells where line {} has {}", cells.size(), first_line_,
                                     order_.size()));
        }
        PointRow row;
        row.line = place.line;
        row.cell[2] = 0;  // if there is no z
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row.cell[order_[i]] = number(order_[i], cells[i], place);
        }
        for (const int first : {kFirstD1, kFirstD2}) {
            const int given = row.cell[first].has_value() + row.cell[first + 1].has_value() +
                              row.cell[first + 2].has_value();
            if (given != 0 && given != 3) {
                place.refuse(fmt::format("{} {} {}: give all three or none", kPointColumns[first],
                                         kPointColumns[first + 1], kPointColumns[first + 2]));
            }
        }
        table_.rows.push_back(row);
    }

    static std::optional<double> number(int column, std::string_view cell, const Place& place) {
        if (cell.empty() && column >= kFirstD1) return std::nullopt;
        const std::optional<double> value = cell_number(cell);
        if (!value || !std::isfinite(*value)) {
            place.refuse(
                fmt::format("{} = '{}' is not a number", kPointColumns[column], shown(cell)));
        }
        const double largest = column < kFirstD1 ? kFarthest : kLargestDerivative;
        if (std::abs(*value) > largest) {
            place.refuse(fmt::format("{} = {:.10g} is out of range: beyond {:.10g}",
                                     kPointColumns[column], *value, largest));
        }
        return value;
    }

    const std::string& file_;
    PointTable table_;
    std::vector<int> order_;  // column of every cell
    int first_line_ = 0;      // line that fixed the columns
};

}  // namespace

PointTable read_point_table(std::string_view text, const std::string& file_name) {
    return Reader(file_name).read(text);
}

}  // namespace curvecore::ref
