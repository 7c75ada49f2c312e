// SPDX-License-Identifier: Apache-2.0
#include "hls/curves/kernel_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

#include "hls/curves/line_text.hpp"

namespace curvecore {
namespace hls {
namespace {

using ref::CurveRow;
using ref::CurveTable;
using ref::TableLine;
using ref::TableTerm;

constexpr std::size_t kColumns = 100;

/// The header behind its remarks.
constexpr const char* kClass = R"(#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {{
namespace hls {{
inline namespace CURVECORE_STORAGE {{

/// {title}.
template <class C>
class {name} : private CurveSteps<C> {{
    using Steps = CurveSteps<C>;
    using Steps::before;
    using Steps::down;
    using Steps::even;
    using Steps::lifted;
    using Steps::named;
    using Steps::odd;
    using Steps::over;
    using Steps::rounded;
    using Steps::series_times;
    using Steps::stieltjes;
    using Steps::sum;
    using Steps::times;
    using Product = typename C::Product;

  public:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;
    static constexpr int kFurther = {further};  // words of a segment that are the table's own

    {name}() = default;
    explicit {name}(const C& format) : Steps(format) {{}}

    /// Opens a segment at its first step.
    void load(const SegmentWords<C>& segment) {{
        Steps::open(segment);
{load}        expand();
    }}

    /// Moves on to the next integration step.
    void step() {{
{step_locals}{step}        Steps::move_auxiliary();
        expand();
    }}

    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {{
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
{sample}        Steps::draw(d, tau, out);
    }}

  private:
    void expand() {{
{expand_locals}{expand}    }}

{members}}};

}}  // namespace CURVECORE_STORAGE
}}  // namespace hls
}}  // namespace curvecore
)";

class Writer {
  public:
    Writer(const CurveTable& table, const std::string& remarks)
        : table_(table), limits_(table), names_(table), line_(table, names_, limits_) {
        std::istringstream stream(remarks);
        for (std::string line; std::getline(stream, line);) lines_.push_back(line);
    }

    std::string text() {
        std::string step = section("next", 2);
        std::string expand = section("anchor", 2);
        if (table_.rows.count("place") != 0) expand += "        Steps::place_origin(place_);\n";
        expand += orders();
        if (table_.rows.count("move") != 0) step += "        Steps::move_origin(move_);\n";
        return head() +
               fmt::format(
                   kClass, fmt::arg("title", table_.title), fmt::arg("name", kernel_class(table_)),
                   fmt::arg("further", table_.further_words()), fmt::arg("load", on_load()),
                   fmt::arg("step", step), fmt::arg("step_locals", locals(RowNames::kStep)),
                   fmt::arg("expand", expand), fmt::arg("expand_locals", locals(RowNames::kExpand)),
                   fmt::arg("sample", of_sample()), fmt::arg("members", members()));
    }

  private:
    std::string head() const {
        std::string remarks;
        for (const std::string& line : lines_) {
            const std::size_t first = line.find_first_not_of(" \t");
            if (first == std::string::npos) continue;
            if (line[first] != '#') break;
            if (line.rfind("# SPDX", 0) != 0) remarks += line.substr(first + 1) + "\n";
        }
        return "// SPDX-License-Identifier: Apache-2.0\n" + remark_lines(remarks) +
               fmt::format(
                   "// Made by `curvecore curve kernel {}`: each line stands above its "
                   "statement.\n",
                   table_.file.substr(table_.file.rfind('/') + 1));
    }

    /// A remark's line without the \ at its end that would join the next line to it.
    static std::string without_splice(const std::string& line) {
        return line.substr(0, line.find_last_not_of("\\ \t") + 1);
    }

    /// Remarks of the table in lines of at most 100 columns.
    static std::string remark_lines(const std::string& remarks) {
        std::string text;
        std::string line = "//";
        std::istringstream words(remarks);
        for (std::string word; words >> word;) {
            if (line.size() + 1 + word.size() > kColumns) {
                text += without_splice(line) + "\n";
                line = "//";
            }
            line += " " + word;
        }
        return line == "//" ? text : text + without_splice(line) + "\n";
    }

    // --- declarations

    std::string declared(const std::string& row) const {
        const CurveRow& of = table_.rows.at(row);
        std::string text = "Coef " + names_.of(row) + (of.of_axis ? "[3]" : "");
        if (names_.array(row)) text += "[C::kMostOrder + 1]";
        text += of.of_axis || names_.array(row) ? " = {};" : " = 0;";
        return fmt::format("{:<44}  // CoefBits {:+} fraction bits: +-{:g}\n", text, of.fraction,
                           of.range());
    }
    std::string locals(RowNames::Function function) const {
        std::string text;
        for (const std::string& row : names_.locals(function)) {
            text += "        " + declared(row);
        }
        return text;
    }
    std::string members() const {
        std::string text;
        for (const std::string& row : names_.members()) {
            text += "    " + declared(row);
        }
        return text;
    }

    // --- functions

    std::string on_load() {
        std::string text;
        std::string axes;
        for (const auto& [place, row] : table_.bus) {
            const CurveRow& of = table_.rows.at(row);
            const ref::BusPlace at = ref::bus_place(place);
            const std::string word =
                names_.of(row) + (of.of_axis ? "[axis]" : "") + (names_.array(row) ? "[0]" : "");
            if (!of.of_axis) {
                text +=
                    fmt::format("        {} = segment.{};\n", word,
                                at.further() ? fmt::format("further[{}]", at.number) : at.field);
            } else if (at.further()) {
                axes +=
                    fmt::format("            {} = segment.further[{} + axis];\n", word, at.number);
            } else {
                axes += fmt::format("            {} = segment.{}[axis];\n", word, at.field);
            }
        }
        if (!axes.empty()) {
            text += "        for (int axis = 0; axis < 3; ++axis) {\n" + axes + "        }\n";
        }
        for (const auto& [name, row] : table_.rows) {
            if (!row.value) continue;
            if (*row.value != std::round(*row.value) || std::abs(*row.value) > 1 << 20) {
                ref::Place{table_.file, std::max(row.line, 1)}.refuse(
                    name + ": a kernel of C++ takes whole numbers as constants alone");
            }
            const auto number = static_cast<long>(*row.value);
            text += fmt::format(
                "        {}{} = {};\n", names_.of(name), names_.array(name) ? "[0]" : "",
                number == 0 ? "0"
                            : fmt::format("Coef(lifted({}, {}))", number, coef_bits(row.fraction)));
        }
        return locals(RowNames::kLoad) + text + section("load", 2);
    }

    std::string of_sample() {
        const ref::RowOperand output = ref::same_row(table_, {table_.output, true, 0, {}});
        if (output.primes != 0) {
            ref::Place{table_.file, std::max(table_.rows.at(table_.output).line, 1)}.refuse(
                table_.output + ": a kernel of C++ draws the orders of a row as they are");
        }
        const auto by_series = [&](int depth) {
            return pad(depth) + "for (int axis = 0; axis < 3; ++axis) {\n" + pad(depth + 1) +
                   fmt::format("d[axis] = Steps::in_tau({}[axis], tau);\n", names_.of(output.row)) +
                   pad(depth) + "}\n";
        };
        if (table_.section("sample").empty()) return by_series(2);
        return pad(2) + "if (C::kSeries) {\n" + by_series(3) + pad(2) + "} else {\n" +
               indented(locals(RowNames::kSample)) + section("sample", 3) + pad(2) + "}\n";
    }
    static std::string indented(const std::string& text) {
        std::string made;
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) made += "    " + line + "\n";
        return made;
    }

    std::string section(const std::string& name, int depth) {
        return statements(table_.section(name), name, depth);
    }
    std::string orders() {
        const auto& lines = table_.section("order");
        if (lines.empty()) return "";
        return "        for (int i = 1; i <= C::kOrder; ++i) {\n" + statements(lines, "order", 3) +
               "        }\n";
    }

    /// Statements of lines; neighbours with one condition and a row of each axis share a loop.
    std::string statements(const std::vector<TableLine>& lines, const std::string& section,
                           int depth) {
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
        for (const TableLine& line : lines) {
            if (section == "order" && !limits_.needed(line.row)) continue;
            const std::string when =
                section == "order" ? condition_of_order(line) : condition_of(line);
            if (when != condition) {
                close(true);
                if (!when.empty()) text += pad(depth) + "if (" + when + ") {\n";
                condition = when;
            }
            const std::set<std::string> all = rows_of_all_axes(line);
            const bool across = read.count(line.row) > 0 ||
                                std::any_of(all.begin(), all.end(), [&](const std::string& row) {
                                    return made.count(row) > 0;
                                });
            if (axes && (!line.of_axis || across)) close(false);
            if (line.of_axis && !axes) {
                text += pad(depth + (condition.empty() ? 0 : 1)) +
                        "for (int axis = 0; axis < 3; ++axis) {\n";
                axes = true;
            }
            if (line.of_axis && section != "order" && all.count(line.row) > 0) {
                line_.refuse(line, "makes " + line.row +
                                       "[k] axis by axis: what it takes of all axes is made in a "
                                       "row of its own");
            }
            if (section == "sample" && names_.member(line.row)) {
                line_.refuse(line, "makes what `sample` makes there alone: " + line.row +
                                       " is made or read elsewhere, too");
            }
            made.insert(line.row);
            read.insert(all.begin(), all.end());
            const int in = depth + (condition.empty() ? 0 : 1) + (axes ? 1 : 0);
            text += pad(in) + "// " + remark(line) + "\n";
            text += wrapped(pad(in) + line_.statement(line, section == "order"), in);
        }
        close(true);
        return text;
    }
    /// Rows that a line reads as [*].
    std::set<std::string> rows_of_all_axes(const TableLine& line) const {
        std::set<std::string> rows;
        for (const TableTerm& term : line.terms) {
            if (!term.all_axes) continue;
            for (const ref::RowOperand* of : {&term.a, &term.b}) {
                if (of->of_axis) rows.insert(ref::same_row(table_, *of).row);
            }
        }
        return rows;
    }
    static std::string pad(int depth) {
        return std::string(4 * static_cast<std::size_t>(depth), ' ');
    }

    /// The line as the file has it.
    std::string remark(const TableLine& line) const {
        const auto n = static_cast<std::size_t>(line.number);
        const std::string text = n >= 1 && n <= lines_.size() ? lines_[n - 1] : line.text;
        const std::size_t first = text.find_first_not_of(' ');
        return without_splice(first == std::string::npos ? line.text : text.substr(first));
    }

    std::string condition_of(const TableLine& line) const {
        const int order = line.order.value_or(0);
        return order <= ref::parameter_of(&ref::CoreParameters::order).low
                   ? ""
                   : fmt::format("C::kOrder >= {}", order);
    }
    std::string condition_of_order(const TableLine& line) const {
        std::string text = limits_.condition(line.row);
        for (const TableLine& anchor : table_.section("anchor")) {
            if (anchor.row != line.row || anchor.order.value_or(0) != 1) continue;
            return text.empty() ? "i > 1" : "i > 1 && " + text;
        }
        return text;
    }

    /// A statement in lines of at most 100 columns.
    static std::string wrapped(const std::string& text, int depth) {
        std::string made;
        std::string rest = text;
        while (rest.size() > kColumns + 1) {
            std::size_t cut = std::string::npos;
            for (const char* at : {" + ", " - ", ", "}) {
                const std::size_t found = rest.rfind(at, kColumns - 2);
                const std::size_t least = 4 * static_cast<std::size_t>(depth + 3);
                if (found != std::string::npos && found > least &&
                    (cut == std::string::npos || cut < least + 20)) {
                    cut = found + (at[0] == ',' ? 1 : 2);
                }
            }
            if (cut == std::string::npos) break;
            made += rest.substr(0, cut) + "\n";
            rest = pad(depth + 1) + rest.substr(cut + 1);
        }
        return made + rest;
    }

    const CurveTable& table_;
    std::vector<std::string> lines_;
    OrderLimits limits_;
    RowNames names_;
    LineText line_;
};

}  // namespace

std::string kernel_text(const CurveTable& table, const std::string& remarks) {
    return Writer(table, remarks).text();
}

std::string kernel_class(const CurveTable& table) {
    std::string name;
    bool first = true;
    for (const char c : table.name) {
        if (c == '_') {
            first = true;
            continue;
        }
        name += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        first = false;
    }
    return name + "Curve";
}

}  // namespace hls
}  // namespace curvecore
