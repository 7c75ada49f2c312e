// SPDX-License-Identifier: Apache-2.0
// A kernel of C++ keeps a table's rows, each as a member or as a local word of the function
// that alone makes and reads it; as a series, or as one word.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ref/curves/order_demand.hpp"

namespace curvecore {
namespace hls {

class RowNames {
  public:
    enum Function { kLoad, kAnchor, kOrders, kStep, kCarry, kSample };

    explicit RowNames(const ref::CurveTable& table) : table_(table) {
        for (const auto& [place, row] : table.bus) uses(row, kLoad);
        for (const auto& [name, row] : table.rows) {
            if (row.value || row.word || row.start) uses(name, kLoad);
        }
        for (const auto& [section, lines] : table.sections) {
            for (const ref::TableLine& line : lines) look_at(line, section);
        }
        const std::string output =
            table.network() ? "" : ref::same_row(table, {table.output, true, 0, {}}).row;
        if (functions_.count(output) != 0) {
            uses(output, kSample);
            arrays_.insert(output);
        }
        // No word of the language, nor a name of CurveSteps that a kernel uses, ends so.
        for (const auto& [row, functions] : functions_) names_[row] = row + "_";
        for (const char* of_sample : {"tau", "d"}) names_[of_sample] = of_sample;
    }

    const std::string& of(const std::string& row) const { return names_.at(row); }
    /// The word of a guarded row with ParameterGuard fraction bits more.
    std::string guarded(const std::string& row) const { return row + "_guarded"; }
    /// Returns whether the kernel keeps orders of the row.
    bool array(const std::string& row) const { return arrays_.count(row) != 0; }

    /// Returns whether the row is a member: more than one function makes or reads it.
    bool member(const std::string& row) const { return functions_.at(row).size() > 1; }

    std::vector<std::string> rows() const {
        std::vector<std::string> rows;
        for (const auto& of : functions_) rows.push_back(of.first);
        return rows;
    }
    std::vector<std::string> members() const {
        std::vector<std::string> rows;
        for (const auto& [row, functions] : functions_) {
            if (functions.size() > 1) rows.push_back(row);
        }
        return rows;
    }
    std::vector<std::string> locals(Function function) const {
        std::vector<std::string> rows;
        for (const auto& [row, functions] : functions_) {
            const bool drawn = row == "d" || row == "tau";  // sample() has them
            if (functions.size() == 1 && *functions.begin() == function && !drawn) {
                rows.push_back(row);
            }
        }
        return rows;
    }

  private:
    void uses(const std::string& row, Function function) { functions_[row].insert(function); }

    void look_at(const ref::TableLine& line, const std::string& section) {
        static const std::map<std::string, Function> kOf{{"load", kLoad},    {"anchor", kAnchor},
                                                         {"order", kOrders}, {"next", kStep},
                                                         {"carry", kCarry},  {"sample", kSample}};
        const Function function = kOf.at(section);
        const bool order = section == "order";
        uses(line.row, function);
        if (order || line.order.value_or(0) > 0) arrays_.insert(line.row);
        if (line.function != ref::TableLine::Function::kTerms) {
            reads(line.series, function, true);
            if (!line.variable.empty()) reads({line.variable, false, 0, {}}, function, false);
        }
        for (const ref::TableTerm& term : line.terms) {
            if (term.meeting == ref::TableTerm::Meeting::kConstant) continue;
            for (const ref::RowOperand* operand : {&term.a, &term.b}) {
                if (!operand->row.empty()) reads(*operand, function, order);
            }
        }
        if (section == "anchor") made_.insert({line.row, line.order.value_or(0)});
    }
    void reads(const ref::RowOperand& operand, Function function, bool by_order) {
        const ref::RowOperand of = ref::same_row(table_, operand);
        uses(of.row, function);
        const bool named = of.order.has_value() && *of.order == of.primes;
        if (table_.rows.at(of.row).series && by_order && !named) arrays_.insert(of.row);
        const int at = of.order.value_or(0) - of.primes;
        if (at <= 0) return;
        arrays_.insert(of.row);
        // An order that no line of `anchor` has made so far is that of the step before.
        if ((function == kAnchor || function == kOrders) && made_.count({of.row, at}) == 0)
            uses(of.row, kLoad);
    }

    const ref::CurveTable& table_;
    std::map<std::string, std::set<Function>> functions_;
    std::set<std::string> arrays_;
    std::set<std::pair<std::string, int>> made_;  // orders, by `anchor`
    std::map<std::string, std::string> names_;
};

}  // namespace hls
}  // namespace curvecore
