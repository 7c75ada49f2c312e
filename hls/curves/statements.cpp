// SPDX-License-Identifier: Apache-2.0
#include "hls/curves/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace curvecore {
namespace hls {

using ref::TableLine;
using ref::TableTerm;

namespace {

/// The last place in the first `columns` where a line may end, as deep in parentheses as none else.
std::size_t cut_of(const std::string& text, std::size_t least, std::size_t columns) {
    std::size_t cut = std::string::npos;
    int depth = 0;
    int shallowest = 1000;
    for (std::size_t n = 0; n < std::min(columns, text.size()); ++n) {
        depth += text[n] == '(' || text[n] == '[' ? 1 : text[n] == ')' || text[n] == ']' ? -1 : 0;
        const bool comma = text.compare(n, 2, ", ") == 0;
        const bool sign = (text.compare(n, 3, " + ") == 0 || text.compare(n, 3, " - ") == 0) &&
                          std::isdigit(static_cast<unsigned char>(text[n + 3])) == 0;
        if (n <= least || depth > shallowest || (!comma && !sign)) continue;
        shallowest = depth;
        cut = n + (comma ? 1 : 2);
    }
    return cut;
}

/// A statement in lines of at most 100 columns.
std::string wrapped(const std::string& text, int depth) {
    std::string made;
    std::string rest = text;
    while (rest.size() > kColumns + 1) {
        const std::size_t cut = cut_of(rest, 4 * static_cast<std::size_t>(depth + 3), kColumns - 1);
        if (cut == std::string::npos) break;
        made += rest.substr(0, cut) + "\n";
        rest = pad(depth + 1) + rest.substr(cut + 1);
    }
    return made + rest;
}

}  // namespace

std::string Statements::section(const std::string& name, int depth) const {
    const bool order = name == "order";
    std::string text;
    std::string condition;
    bool axes = false;
    std::set<std::string> made;  // in the loop over the axes
    std::set<std::string> read;  // there, of all axes
    const auto close = [&](bool also_condition) {
        const int in = depth + (condition.empty() ? 0 : 1);
        if (axes) text += pad(in) + "}\n";
        axes = false;
        made.clear();
        read.clear();
        if (also_condition && !condition.empty()) {
            text += pad(depth) + "}\n";
            condition.clear();
        }
    };
    for (const TableLine& line : table_.section(name)) {
        if (order && !limits_.needed(line.row)) continue;
        const std::string when = this->condition(line, order);
        if (when != condition) {
            close(true);
            if (!when.empty()) text += pad(depth) + "if (" + when + ") {\n";
            condition = when;
        }
        const std::set<std::string> all = rows_of_all_axes(line);
        const bool across = read.count(line.row) > 0 ||
                            std::any_of(all.begin(), all.end(),
                                        [&](const auto& row) { return made.count(row) > 0; });
        if (axes && (!line.of_axis || across)) close(false);
        if (line.of_axis && !axes) {
            text += pad(depth + (condition.empty() ? 0 : 1)) +
                    "for (int axis = 0; axis < 3; ++axis) {\n";
            axes = true;
        }
        check(line, name, all);
        made.insert(line.row);
        read.insert(all.begin(), all.end());
        const int in = depth + (condition.empty() ? 0 : 1) + (axes ? 1 : 0);
        text += pad(in) + "// " + remark(line) + "\n";
        for (const std::string& statement : line_.statements(line, name)) {
            text += wrapped(pad(in) + statement, in);
        }
    }
    close(true);
    return text;
}

void Statements::check(const TableLine& line, const std::string& section,
                       const std::set<std::string>& all) const {
    if (line.of_axis && section != "order" && all.count(line.row) > 0) {
        line_.refuse(line, "makes " + line.row +
                               "[k] axis by axis: what it takes of all axes is made in a row of "
                               "its own");
    }
    if (section == "sample" && names_.member(line.row)) {
        line_.refuse(line, "makes what `sample` makes there alone: " + line.row +
                               " is made or read elsewhere, too");
    }
}

/// Rows that a line reads as [*].
std::set<std::string> Statements::rows_of_all_axes(const TableLine& line) const {
    std::set<std::string> rows;
    for (const TableTerm& term : line.terms) {
        if (!term.all_axes) continue;
        for (const ref::RowOperand* of : {&term.a, &term.b}) {
            if (of->of_axis) rows.insert(ref::same_row(table_, *of).row);
        }
    }
    return rows;
}

/// The line as the file has it.
std::string Statements::remark(const TableLine& line) const {
    const auto n = static_cast<std::size_t>(line.number);
    const std::string text = n >= 1 && n <= lines_.size() ? lines_[n - 1] : line.text;
    const std::size_t first = text.find_first_not_of(' ');
    return without_splice(first == std::string::npos ? line.text : text.substr(first));
}

std::string Statements::condition(const TableLine& line, bool order) const {
    if (!order) {
        const int named = line.order.value_or(0);
        return named <= ref::parameter_of(&ref::CoreParameters::order).low
                   ? ""
                   : fmt::format("C::kOrder >= {}", named);
    }
    std::string text = limits_.condition(line.row);
    if (ref::first_order(table_, line.row) == 1) return text;
    if (text.empty()) return "i > 1";
    return "i > 1 && " + (text.find_first_of("|?") == std::string::npos ? text : "(" + text + ")");
}

}  // namespace hls
}  // namespace curvecore
