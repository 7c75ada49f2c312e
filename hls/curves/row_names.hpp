// SPDX-License-Identifier: Apache-2.0
// A kernel of C++ keeps a table's rows, each as a member or as a local word of the function
// that alone makes and reads it; as a series, or as one word.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "ref/curves/order_demand.hpp"

namespace curvecore {
namespace hls {

class RowNames {
  public:
    enum Function { kLoad, kExpand, kStep, kSample };

    explicit RowNames(const ref::CurveTable& table) : table_(table) {
        for (const auto& [place, row] : table.bus) uses(row, kLoad);
        for (const auto& [name, row] : table.rows) {
            if (row.value) uses(name, kLoad);
        }
        for (const auto& [section, lines] : table.sections) {
            for (const ref::TableLine& line : lines) look_at(line, section);
        }
        if (functions_.count(table.output) != 0) {
            uses(table.output, kSample);
            arrays_.insert(table.output);
        }
        std::set<std::string> taken;
        for (const auto& [row, functions] : functions_) {
            std::string name = row;
            if (functions.size() > 1 || reserved().count(name) != 0) name += "_";
            while (taken.count(name) != 0) name += "_";
            taken.insert(name);
            names_[row] = name;
        }
        names_["tau"] = "tau";
    }

    const std::string& of(const std::string& row) const { return names_.at(row); }
    /// Returns whether the kernel keeps orders of the row.
    bool array(const std::string& row) const { return arrays_.count(row) != 0; }

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
    static const std::set<std::string>& reserved() {
        static const std::set<std::string> kWords{
            "alignas",   "and",       "asm",     "auto",      "axis",     "before",      "bool",
            "break",     "case",      "catch",   "char",      "class",    "const",       "continue",
            "default",   "delete",    "do",      "double",    "down",     "else",        "enum",
            "even",      "explicit",  "export",  "extern",    "false",    "float",       "for",
            "friend",    "goto",      "i",       "if",        "inline",   "int",         "lifted",
            "load",      "long",      "mutable", "namespace", "new",      "noexcept",    "not",
            "nullptr",   "odd",       "offset",  "operator",  "or",       "out",         "over",
            "private",   "protected", "public",  "register",  "return",   "rounded",     "sample",
            "segment",   "short",     "signed",  "sizeof",    "static",   "step",        "struct",
            "stieltjes", "sum",       "switch",  "template",  "this",     "throw",       "times",
            "true",      "try",       "typedef", "typeid",    "typename", "union",       "unsigned",
            "using",     "virtual",   "void",    "volatile",  "while",    "xor",         "C",
            "Coef",      "Fine",      "Product", "Steps",     "expand",   "series_times"};
        return kWords;
    }

    void uses(const std::string& row, Function function) { functions_[row].insert(function); }

    void look_at(const ref::TableLine& line, const std::string& section) {
        const Function function = section == "load"     ? kLoad
                                  : section == "next"   ? kStep
                                  : section == "sample" ? kSample
                                                        : kExpand;
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
    }
    void reads(const ref::RowOperand& operand, Function function, bool by_order) {
        const ref::RowOperand of = ref::same_row(table_, operand);
        uses(of.row, function);
        const bool named = of.order.has_value() && *of.order == of.primes;
        if (table_.rows.at(of.row).series && by_order && !named) arrays_.insert(of.row);
        if (of.order.value_or(0) > of.primes) arrays_.insert(of.row);
    }

    const ref::CurveTable& table_;
    std::map<std::string, std::set<Function>> functions_;
    std::set<std::string> arrays_;
    std::map<std::string, std::string> names_;
};

}  // namespace hls
}  // namespace curvecore
