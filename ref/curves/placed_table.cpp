// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/placed_table.hpp"

#include <utility>

#include "ref/curves/order_demand.hpp"

namespace curvecore::ref {

PlacedTable::PlacedTable(const CurveTable& table, int order, bool polynomial, bool anchored)
    : table_(table) {
    for (const auto& of : table.rows) numbers_.emplace(of.first, static_cast<int>(rows()));
    const std::map<std::string, int> needed = order_demand(table, order, polynomial, anchored);
    const std::string unused = table.samples_by_lines(polynomial) ? "move" : "place";
    for (const char* name : {"load", "anchor", "order", "next", "carry", "sample"}) {
        std::vector<PlacedLine>& lines = sections_[name];
        for (const TableLine& line : table.section(name)) {
            if (line.order.value_or(0) > order) continue;
            const bool of_order = name == std::string("order");
            if (of_order && needed.count(line.row) == 0) continue;
            if (name == std::string("carry") && line.row == unused) continue;
            lines.push_back(placed(line, of_order, needed));
        }
    }
}

PlacedOperand PlacedTable::operand(const RowOperand& of) const {
    const RowOperand row = same_row(table_, of);
    const CurveRow& made = table_.rows.at(row.row);
    return {numbers_.at(row.row),
            made.fraction,
            made.of_axis,
            made.series,
            table_.guarded.count(row.row) != 0,
            row.primes,
            row.order};
}

PlacedLine PlacedTable::placed(const TableLine& line, bool order,
                               const std::map<std::string, int>& needed) const {
    PlacedLine made;
    made.line = &line;
    made.row = numbers_.at(line.row);
    made.guarded = table_.guarded.count(line.row) != 0;
    made.moves = line.row == "move";
    made.places = line.row == "place";
    if (order) {
        made.last = needed.at(line.row);
        made.first = first_order(table_, line.row);
    }
    if (line.function != TableLine::Function::kTerms) made.series = operand(line.series);
    if (line.function == TableLine::Function::kHorner) made.variable = numbers_.at("tau");
    if (!line.variable.empty()) made.variable = numbers_.at(line.variable);
    for (const TableTerm& term : line.terms) made.terms.push_back(placed(term));
    return made;
}

PlacedTerm PlacedTable::placed(const TableTerm& term) const {
    PlacedTerm made;
    made.term = &term;
    if (term.meeting == TableTerm::Meeting::kConstant) return made;
    made.a = operand(term.a);
    if (term.b.row.empty()) return made;
    made.b = operand(term.b);
    made.meets = meet_as_series(table_, term);
    const auto rate = [&](const RowOperand& of) { return table_.rows.at(of.row).rate(of.row); };
    made.integral = made.meets && (rate(term.a) || rate(term.b));
    if (made.meets && rate(term.a) && !rate(term.b)) std::swap(made.a, made.b);
    return made;
}

}  // namespace curvecore::ref
