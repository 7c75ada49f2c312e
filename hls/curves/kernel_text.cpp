// SPDX-License-Identifier: Apache-2.0
#include "hls/curves/kernel_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

#include "hls/curves/statements.hpp"

namespace curvecore {
namespace hls {
namespace {

using ref::CurveRow;
using ref::CurveTable;

/// The header behind its remarks.
constexpr const char* kClass = R"(#pragma once

#include "hls/curves/curve_steps.hpp"

// clang-format off
namespace curvecore {{
namespace hls {{
inline namespace CURVECORE_STORAGE {{

/// {title}.
template <class C>
class {name} : protected CurveSteps<C> {{
    using Steps = CurveSteps<C>;
    using Steps::before;
    using Steps::down;
    using Steps::even;
    using Steps::keep;
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
{further}    {name}() = default;
    explicit {name}(const C& format) : Steps(format, "{curve}", rows()) {{}}

{opening}{load}        anchor();
        orders();
    }}

    /// Moves on to the next integration step.
    void step() {{
{step_locals}{step}{go_on}        orders();
    }}

{sample}  {access}:  // the words of a step
    /// Makes what a step begins with.
    void anchor() {{
{anchor_locals}{anchor}    }}
{carry}
    /// Makes the orders of a step's series.
    void orders() {{
{order_locals}{orders}    }}

{members}
  private:
    enum class Row {{ {rows} }};
    /// Names and fraction bits of the rows, for a format that notes their ranges.
    static const WordRow* rows() {{
        static constexpr WordRow kRows[] = {{
{row_words}            {{nullptr, 0}}}};
        return kRows;
    }}
}};

}}  // namespace CURVECORE_STORAGE
}}  // namespace hls
}}  // namespace curvecore
)";

/// Lines of a text, as they are.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

constexpr const char* kSample =
    R"(    /// Sets the fine position at an offset of quanta into the present step.
    void sample(const Word<kLengthBits + 1>& offset, Fine* out) const {{
        const Coef tau = Steps::tau_of(offset);
        Coef d[3];
{}        Steps::draw(d, tau, out);
    }}

)";

class Writer {
  public:
    Writer(const CurveTable& table, const std::string& remarks)
        : table_(table),
          lines_(lines_of(remarks)),
          limits_(table),
          names_(table),
          statements_(table, names_, limits_, lines_) {}

    std::string text() const {
        return head() +
               fmt::format(
                   kClass, fmt::arg("title", table_.title), fmt::arg("name", kernel_class(table_)),
                   fmt::arg("curve", table_.name), fmt::arg("further", further()),
                   fmt::arg("opening", opening()),
                   fmt::arg("access", table_.network() ? "public" : "protected"),
                   fmt::arg("load", on_load()), fmt::arg("step", on_step()),
                   fmt::arg("step_locals", locals(RowNames::kStep)), fmt::arg("go_on", go_on()),
                   fmt::arg("anchor_locals", locals(RowNames::kAnchor)),
                   fmt::arg("anchor", anchor()), fmt::arg("carry", carry()),
                   fmt::arg("order_locals", locals(RowNames::kOrders)),
                   fmt::arg("orders", orders()),
                   fmt::arg("sample", table_.network() ? "" : fmt::format(kSample, of_sample())),
                   fmt::arg("members", members()), fmt::arg("rows", row_list()),
                   fmt::arg("row_words", row_words()));
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
        if (table_.guarded.count(row) != 0) {
            const std::string guarded =
                fmt::format("{:<44}  // the same, and ParameterGuard more\n",
                            "typename C::FineParameter " + names_.guarded(row) + " = 0;");
            return of.start ? word(row) + "    " + guarded : guarded;
        }
        return word(row);
    }
    std::string word(const std::string& row) const {
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

    /// Rows whose ranges a format may note.
    std::vector<std::string> noted() const {
        std::vector<std::string> rows;
        for (const std::string& row : names_.rows()) {
            const bool wide = table_.guarded.count(row) != 0 && !table_.rows.at(row).start;
            if (row != "tau" && !wide) rows.push_back(row);
        }
        return rows;
    }
    std::string row_list() const {
        std::string text;
        std::size_t used = 0;
        for (const std::string& row : noted()) {
            if (!text.empty()) text += ",";
            const std::string name = names_.of(row);
            if (text.size() - used + name.size() > kColumns - 30) {
                text += "\n" + pad(5);
                used = text.size();
            } else if (!text.empty()) {
                text += " ";
            }
            text += name;
        }
        return text;
    }
    std::string row_words() const {
        std::string text;
        for (const std::string& row : noted()) {
            text += pad(3) + fmt::format("{{\"{}\", {}}},\n", row, table_.rows.at(row).fraction);
        }
        return text;
    }

    // --- functions

    std::string further() const {
        if (table_.network()) return "\n";
        return fmt::format(
            "    static constexpr int kFurther = {};  // words of a segment that are the table's "
            "own\n\n",
            table_.further_words());
    }
    /// The beginning of load(): of a network its words are given, in the order of their names.
    std::string opening() const {
        if (!table_.network()) {
            return "    /// Opens a segment at its first step.\n"
                   "    void load(const SegmentWords<C>& segment) {\n"
                   "        Steps::open(segment);\n";
        }
        std::string arguments;
        std::string text;
        for (const auto& [name, row] : table_.rows) {
            if (!row.word && (!row.start || row.value)) continue;
            arguments += (arguments.empty() ? "const Coef& " : ", const Coef& ") + name;
            text += fmt::format("        {}{} = {};\n", names_.of(name),
                                names_.array(name) ? "[0]" : "", name);
        }
        return "    /// Begins with a first step.\n    void load(" + arguments + ") {\n" + text;
    }
    std::string on_step() const {
        return statements_.section("next", 2) +
               (ref::makes(table_, "next", "move") ? pad(2) + "Steps::move_origin(move_);\n" : "") +
               (table_.network() ? "" : pad(2) + "Steps::move_auxiliary();\n");
    }
    static std::string either(const char* condition, const char* one, const char* other) {
        return fmt::format(
            "        if ({}) {{\n            {};\n        }} else {{\n            {};\n        "
            "}}\n",
            condition, one, other);
    }
    std::string go_on() const {
        return table_.carries(false) ? either("C::kAnchor", "anchor()", "carry()")
                                     : pad(2) + "anchor();\n";
    }
    std::string anchor() const {
        return statements_.section("anchor", 2) + (ref::makes(table_, "anchor", "place")
                                                       ? pad(2) + "Steps::place_origin(place_);\n"
                                                       : "");
    }
    std::string carry() const {
        if (!table_.carries(false)) return "";
        return "    /// The same with Anchor 0, of the step before.\n    void carry() {\n" +
               locals(RowNames::kCarry) + statements_.section("carry", 2) +
               (ref::makes(table_, "carry", "place")
                    ? either("C::kSeries", "Steps::move_origin(move_)",
                             "Steps::place_origin(place_)")
                    : "") +
               "    }\n";
    }

    std::string on_load() const {
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
        for (const std::string& row : table_.guarded) {
            if (!table_.rows.at(row).start) continue;
            text += fmt::format("        {} = Steps::guarded({});\n", names_.guarded(row),
                                names_.of(row));
        }
        return locals(RowNames::kLoad) + text + statements_.section("load", 2);
    }

    std::string of_sample() const {
        const ref::RowOperand output = ref::same_row(table_, {table_.output, true, 0, {}});
        if (output.primes != 0) {
            ref::Place{table_.file, std::max(table_.rows.at(table_.output).line, 1)}.refuse(
                table_.output + ": a kernel of C++ draws the orders of a row as they are");
        }
        const auto by_series = [&](int depth) {
            return pad(depth) + "for (int axis = 0; axis < 3; ++axis) {\n" + pad(depth + 1) +
                   fmt::format("d[axis] = Steps::in_tau(Row::{0}, {0}[axis], tau);\n",
                               names_.of(output.row)) +
                   pad(depth) + "}\n";
        };
        if (table_.section("sample").empty()) return by_series(2);
        return pad(2) + "if (C::kSeries) {\n" + by_series(3) + pad(2) + "} else {\n" +
               indented(locals(RowNames::kSample)) + statements_.section("sample", 3) + pad(2) +
               "}\n";
    }
    static std::string indented(const std::string& text) {
        std::string made;
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) made += "    " + line + "\n";
        return made;
    }

    std::string orders() const {
        if (table_.section("order").empty()) return "";
        return "        for (int i = 1; i <= C::kOrder; ++i) {\n" +
               statements_.section("order", 3) + "        }\n";
    }

    const CurveTable& table_;
    std::vector<std::string> lines_;
    OrderLimits limits_;
    RowNames names_;
    Statements statements_;
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
    return name + (table.network() ? "Network" : "Curve");
}

}  // namespace hls
}  // namespace curvecore
