// SPDX-License-Identifier: Apache-2.0
// Checks of a table's lines together; table_reader.hpp reads each.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/curves/order_demand.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

/// Checks the rows that place a step or a sample: each is made in its section, of each axis, in
/// words of one fraction.
/// @throws InputError
inline void check_places(const CurveTable& table) {
    constexpr int kFraction = -2;
    const std::map<std::string, std::string> sections{
        {"place", "anchor"}, {"move", "next"}, {"d", "sample"}};
    for (const auto& [section, lines] : table.sections) {
        for (const TableLine& line : lines) {
            const auto of = sections.find(line.row);
            if (of == sections.end()) continue;
            const Place place{table.file, line.number};
            const bool goes_on = section == "carry" && line.row != "d";
            if (of->second != section && !goes_on) {
                place.refuse(line.row + " is made in `" + of->second + "`");
            }
            if (!line.of_axis) place.refuse(line.row + " is a row of each axis");
        }
    }
    for (const auto& [name, section] : sections) {
        const auto made = table.rows.find(name);
        if (made == table.rows.end()) continue;
        const CurveRow& row = made->second;
        if (row.word || row.start || row.value || row.same_as) {
            Place{table.file, std::max(row.line, 1)}.refuse(
                fmt::format("{} is made in `{}`", name, section));
        }
        if (row.fraction == kFraction) continue;
        const bool output = name == "d" && table.section("sample").empty();
        const std::string& of = output ? table.output : name;
        Place{table.file, table.rows.at(of).line}.refuse(
            of + " is a place in the step: its fraction is -2");
    }
}

/// Checks that `carry` places a step as `anchor` does, or moves it: by the samples' mode.
/// @throws InputError
inline void check_carry(const CurveTable& table, const Place& end) {
    if (table.section("carry").empty() || table.rows.count("place") == 0) return;
    for (const char* row : {"move", "place"}) {
        if (!makes(table, "carry", row)) {
            end.refuse(
                fmt::format("`anchor` places the steps: `carry` makes move[k] and place[k], "
                            "it has no {}[k]",
                            row));
        }
    }
    if (table.section("sample").empty()) end.refuse("`carry` places no step without `sample`");
}

/// Checks that a network alone has what a kernel of it has: words of no axis, and no place.
/// @throws InputError
inline void check_network(const CurveTable& table) {
    for (const auto& [name, row] : table.rows) {
        if (!row.of_axis) continue;
        Place{table.file, std::max(row.line, 1)}.refuse(
            name + " is a row of each axis: a network alone has none");
    }
    for (const auto& [section, lines] : table.sections) {
        for (const TableLine& line : lines) {
            if (section != "sample" && line.down == 0) continue;
            Place{table.file, line.number}.refuse("a network alone has no samples, and no scale s");
        }
    }
}

/// Checks that the guarded rows are what `next` makes of each other, or of a row `>> s`.
/// @throws InputError
inline void check_guards(const CurveTable& table, const Place& end) {
    const auto guarded = [&](const std::string& row) { return table.guarded.count(row) != 0; };
    const auto alike = [&](const TableLine& line, const TableTerm& term) {
        return term.meeting == TableTerm::Meeting::kAlone && term.halvings == 0 &&
               std::abs(term.number) == 1 && guarded(term.a.row) &&
               table.rows.at(term.a.row).fraction == line.fraction;
    };
    for (const std::string& row : table.guarded) {
        if (!makes(table, "next", row)) end.refuse("guard: no line of `next` makes " + row);
    }
    const auto wide = [&](const RowOperand& of) {  // it has no word without its guard bits
        return guarded(of.row) && !table.rows.at(of.row).start;
    };
    for (const auto& [section, lines] : table.sections) {
        for (const TableLine& line : lines) {
            if (guarded(line.variable)) {
                Place{table.file, line.number}.refuse(line.variable +
                                                      " is guarded: no polynomial is of it");
            }
            if (!guarded(line.row)) {
                for (const TableTerm& term : line.terms) {
                    if (!wide(term.a) && !wide(term.b)) continue;
                    Place{table.file, line.number}.refuse(
                        "a guarded row that is not carried is read by guarded rows alone");
                }
                continue;
            }
            const bool down = line.down != 0 && !guarded(line.terms.front().a.row);
            const bool sum = line.function == TableLine::Function::kTerms &&
                             std::all_of(line.terms.begin(), line.terms.end(),
                                         [&](const TableTerm& term) { return alike(line, term); });
            if (section == "next" && !line.of_axis && (down || sum)) continue;
            Place{table.file, line.number}.refuse(
                line.row +
                " is guarded: a line of `next` makes it, a sum of guarded rows or one "
                "other row >> s");
        }
    }
}

/// Checks that no line of `order` reads an order that is made there, or further down.
/// @throws InputError
inline void check_orders(const CurveTable& table) {
    const std::vector<TableLine>& lines = table.section("order");
    const auto rate = [&](const RowOperand& of) {
        return !of.row.empty() && table.rows.at(of.row).rate(of.row);
    };
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        const auto early = [&](const RowOperand& read) {
            if (read.row.empty()) return false;
            const RowOperand of = same_row(table, read);
            const auto same = [&](const TableLine& other) { return other.row == of.row; };
            return of.primes == 0 && !of.order && std::any_of(line, lines.end(), same);
        };
        for (const TableTerm& term : line->terms) {
            if (term.meeting == TableTerm::Meeting::kConstant) continue;
            // A series that meets a rate, or one of earlier orders, is read up to those before.
            const bool meets = meet_as_series(table, term);
            const auto whole = [&](const RowOperand& read, const RowOperand& other) {
                return !meets || rate(read) || (!rate(other) && same_row(table, other).primes == 0);
            };
            const bool a = early(term.a) && whole(term.a, term.b);
            if (!a && !(early(term.b) && whole(term.b, term.a))) continue;
            Place{table.file, line->number}.refuse((a ? term.a.row : term.b.row) +
                                                   " has this order from here or further down");
        }
    }
}

}  // namespace curvecore::ref
