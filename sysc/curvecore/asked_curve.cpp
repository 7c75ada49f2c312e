// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/asked_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/curves/named_table.hpp"

namespace curvecore::sysc {
std::map<std::string, std::array<double, 3>> rows_of(const ref::CurveTable& table,
                                                     const CurveOptions& asked) {
    std::map<std::string, std::array<double, 3>> values;
    std::vector<std::string> names;
    for (const auto& [field, row] : table.bus) names.push_back(row);
    for (const RowValues& of : asked.rows) {
        if (values.count(of.row) != 0) {
            throw UsageError(fmt::format("--row {}: it has two values", of.row));
        }
        if (std::find(names.begin(), names.end(), of.row) == names.end()) {
            throw UsageError(
                fmt::format("--row {}: {} takes {}", of.row, table.name, fmt::join(names, ", ")));
        }
        const std::size_t count = table.rows.at(of.row).of_axis ? 3 : 1;
        if (of.values.size() != count) {
            throw UsageError(fmt::format("--row {}: expected {} values, not {}", of.row, count,
                                         of.values.size()));
        }
        std::copy(of.values.begin(), of.values.end(), values[of.row].begin());
    }
    for (const std::string& row : names) {
        if (values.count(row) == 0) {
            throw UsageError(fmt::format("--row {}=..: {} needs its value", row, table.name));
        }
    }
    return values;
}

NamedCurve derived(const CurveOptions& asked) {
    if (!asked.rows.empty() || asked.length > 0) {
        throw UsageError("--x --y: the formulas say the rows and the length");
    }
    ref::CurveFormula formula = asked.formula;
    formula.name = std::filesystem::path(asked.part.options.file).stem();
    const bool named = !formula.name.empty() && std::isalpha(formula.name[0]) != 0 &&
                       std::all_of(formula.name.begin(), formula.name.end(), [](unsigned char c) {
                           return std::isalnum(c) != 0 || c == '_';
                       });
    if (!named)
        throw UsageError(fmt::format("FILE '{}': the name of a curve is letters and digits",
                                     asked.part.options.file));
    if (asked.x.empty() || asked.y.empty()) {
        throw UsageError("--x and --y: the formulas of a curve, and --z in space");
    }
    for (const RowValues& constant : asked.constants) {
        if (constant.values.size() != 1) {
            throw UsageError(fmt::format("--let {}: expected one number", constant.row));
        }
        formula.constants[constant.row] = constant.values[0];
    }
    formula.coordinates = {asked.x, asked.y};
    if (!asked.z.empty()) formula.coordinates.push_back(asked.z);
    try {
        const ref::DerivedTable made = ref::derive_table(formula);
        auto table = std::make_shared<ref::CurveTable>(
            ref::read_curve_text(formula.name + ".net", made.text));
        check_table_name(*table);
        table->powers = ref::row_powers(*table);
        return {table, made.rows, made.length,
                ref::Vec3(made.start[0], made.start[1], made.start[2]), made.text};
    } catch (const ref::FormulaError& error) {
        throw UsageError(error.what());
    }
}

NamedCurve named_curve(const CurveOptions& asked) {
    if (asked.has_formulas()) return derived(asked);
    if (asked.start.size() != 3) throw UsageError("--start: expected X,Y,Z");
    if (!(asked.length > 0)) throw UsageError("--length: the length of the curve, as 40mm");
    NamedCurve curve;
    curve.table = named_table(asked.part.options.file);
    curve.rows = rows_of(*curve.table, asked);
    curve.length = asked.length;
    curve.start = ref::Vec3(asked.start[0], asked.start[1], asked.start[2]);
    return curve;
}

ref::Move move_along(const NamedCurve& curve) {
    ref::Move move;
    move.kind = ref::Move::Kind::kTable;
    move.start = curve.start;
    move.table.table = curve.table.get();
    for (const auto& [place, row] : curve.table->bus) {
        const std::size_t axes = curve.table->rows.at(row).of_axis ? 3 : 1;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            move.table.at(place, static_cast<int>(axis)) = curve.rows.at(row)[axis];
        }
    }
    move.table_length = move.to = curve.length;
    try {
        const ref::TableCurve along(move.table, move.start, move.table_length);
        along.check_path();
        move.end = along.position(move.table_length);
    } catch (const std::domain_error& error) {
        throw UsageError(fmt::format("{}: {}", curve.table->file, error.what()));
    }
    return move;
}

}  // namespace curvecore::sysc
