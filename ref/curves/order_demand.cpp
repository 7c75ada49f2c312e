// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/order_demand.hpp"

#include <algorithm>

namespace curvecore::ref {

RowOperand same_row(const CurveTable& table, RowOperand operand) {
    for (const CurveRow* row = &table.rows.at(operand.row); row->same_as;
         row = &table.rows.at(operand.row)) {
        operand.row = row->same_as->row;
        operand.primes += row->same_as->primes;
    }
    return operand;
}

bool makes(const CurveTable& table, const std::string& section, const std::string& row) {
    const std::vector<TableLine>& lines = table.section(section);
    return std::any_of(lines.begin(), lines.end(),
                       [&](const TableLine& line) { return line.row == row; });
}

int first_order(const CurveTable& table, const std::string& row) {
    const std::vector<TableLine>& anchor = table.section("anchor");
    const bool begun = std::any_of(anchor.begin(), anchor.end(), [&](const TableLine& line) {
        return line.row == row && line.order.value_or(0) == 1;
    });
    return begun ? 2 : 1;
}

bool meet_as_series(const CurveTable& table, const TableTerm& term) {
    const auto series = [&](const RowOperand& of) {
        return table.rows.at(of.row).series && !of.order;
    };
    return term.meeting == TableTerm::Meeting::kProduct && series(term.a) && series(term.b);
}

std::map<std::string, int> order_demand(const CurveTable& table, int order, bool polynomial,
                                        bool anchored) {
    const bool carries = table.carries(anchored);
    std::map<std::string, int> needed;
    bool changed = true;
    const auto want = [&](const RowOperand& read, int i) {
        const RowOperand row = same_row(table, read);
        const int lower = i - row.primes;
        if (table.rows.at(row.row).series && !row.order && lower > needed[row.row]) {
            needed[row.row] = lower;
            changed = true;
        }
    };
    const auto carried = [&](const TableLine& line) {
        if (line.function != TableLine::Function::kTerms) {
            const bool polished = !carries && table.rows.at(line.series.row).polished;
            want(line.series, order - (polished ? 1 : 0));
        }
    };
    for (const TableLine& line : table.section("next")) {
        carried(line);
    }
    for (const TableLine& line : table.section(carries ? "carry" : "")) {
        if (line.row != "move" || !table.samples_by_lines(polynomial)) carried(line);
    }
    if (table.samples_by_lines(polynomial)) {
        for (const TableLine& line : table.section("sample")) {
            carried(line);
        }
    } else if (!table.network()) {
        RowOperand output;
        output.row = table.output;
        want(output, order);
    }
    while (changed) {
        changed = false;
        for (const TableLine& line : table.section("order")) {
            const int i = needed[line.row];
            for (const TableTerm& term : line.terms) {
                if (i == 0 || term.meeting == TableTerm::Meeting::kConstant) {
                    continue;
                }
                const auto rate = [&](const RowOperand& of) {
                    return table.rows.at(of.row).rate(of.row);
                };
                const bool stieltjes =
                    meet_as_series(table, term) && (rate(term.a) || rate(term.b));
                want(term.a, i - (stieltjes && !rate(term.a) ? 1 : 0));
                if (!term.b.row.empty()) {
                    want(term.b, i - (stieltjes && !rate(term.b) ? 1 : 0));
                }
            }
        }
    }
    return needed;
}

}  // namespace curvecore::ref
