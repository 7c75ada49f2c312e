// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/state/named_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ref/text/csv_cells.hpp"

namespace curvecore::ref {
namespace {

/// Numbers apart by blanks; without any where one of them is no number.
std::vector<double> numbers_of(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view cell : cells_of(text, ' ')) {
        if (cell.empty()) continue;
        const std::optional<double> number = cell_number(cell);
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

std::string taken(const CurveTable& table) {
    std::string names;
    for (const auto& [field, row] : table.bus) names += row + ", ";
    return names + "length";
}

}  // namespace

NamedCurve read_named_curve(const std::string& text, const CurveTable* table, const Place& place) {
    const std::vector<std::string_view> items = cells_of(text);
    const std::string name(items.front());
    if (table == nullptr || table->name != name) {
        place.refuse(fmt::format("a curve '{}': --curve {} names its table, or the file of it",
                                 shown(name), shown(name)));
    }
    NamedCurve named;
    named.piece.table = table;
    named.line = place.line;
    std::set<std::string> given;
    for (std::size_t i = 1; i < items.size(); ++i) {
        const std::size_t equals = items[i].find('=');
        const std::string key(trim(items[i].substr(0, equals)));
        const std::vector<double> numbers = equals == std::string_view::npos
                                                ? std::vector<double>{}
                                                : numbers_of(trim(items[i].substr(equals + 1)));
        if (numbers.empty()) {
            place.refuse(fmt::format("'{}' of this {}: expected ROW=NUMBER, or ROW=X Y Z",
                                     shown(items[i]), name));
        }
        if (!given.insert(key).second) {
            place.refuse(fmt::format("{} of this {} stands there twice", shown(key), name));
        }
        if (key == "length") {
            if (numbers.size() != 1 || !(numbers[0] > 0)) {
                place.refuse(fmt::format("the length of this {} is one number above 0", name));
            }
            named.length = numbers[0];
            continue;
        }
        const auto found = std::find_if(table->bus.begin(), table->bus.end(),
                                        [&](const auto& of) { return of.second == key; });
        if (found == table->bus.end()) {
            place.refuse(fmt::format("{} takes {}, not '{}'", name, taken(*table), shown(key)));
        }
        const std::size_t axes = table->rows.at(key).of_axis ? 3 : 1;
        if (numbers.size() != 1 && numbers.size() != axes) {
            place.refuse(fmt::format("{} of this {} takes {}, not {} numbers", key, name,
                                     axes == 3 ? "one number or three" : "one number",
                                     numbers.size()));
        }
        for (std::size_t axis = 0; axis < axes; ++axis) {
            named.piece.at(found->first, static_cast<int>(axis)) =
                numbers[numbers.size() == 1 ? 0 : axis];
        }
    }
    for (const auto& [field, row] : table->bus) {
        if (given.count(row) == 0) place.refuse(fmt::format("this {} needs {}=..", name, row));
    }
    if (given.count("length") == 0) place.refuse(fmt::format("this {} needs length=..", name));
    return named;
}

}  // namespace curvecore::ref
