// SPDX-License-Identifier: Apache-2.0
// `curvecore curve`: a table of a curve (ref/curves/curve_table.hpp): its rows, what the engine
// needs for it, and how far its words may be off a segment of it.
#include <fmt/format.h>

#include <algorithm>

#include "ref/bound/table_bound.hpp"
#include "ref/curves/order_demand.hpp"
#include "ref/curves/table_reader.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/curvecore/commands.hpp"

namespace curvecore::sysc {
namespace {

enum class CurveAction { kCheck };
constexpr std::array<std::string_view, 1> kCurveActions{"check"};

/// A row's values of a segment, of X Y Z where it has axes.
struct RowValues {
    std::string row;
    std::vector<double> values;
};

struct CurveOptions {
    CurveAction action = CurveAction::kCheck;
    std::string file;
    std::vector<ParameterList> set;
    std::vector<RowValues> rows;
    int step_exponent = 20;
    int down = 0;
    int steps = 1;
};

RowValues row_values(const std::string& option, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw UsageError(fmt::format("{} '{}': expected ROW=VALUE or ROW=X,Y,Z", option, text));
    }
    return {text.substr(0, equals), list_of(plain_number)(option, text.substr(equals + 1))};
}

/// The segment that is asked for. @throws UsageError: a row that the bus has not, or without value
ref::TableSegment segment_of(const ref::CurveTable& table, const CurveOptions& asked) {
    ref::TableSegment segment;
    segment.k = asked.step_exponent;
    segment.lambda = asked.step_exponent + asked.down;
    segment.steps = asked.steps;
    std::vector<std::string> names;
    for (const auto& [field, row] : table.bus) names.push_back(row);
    for (const RowValues& of : asked.rows) {
        if (segment.values.count(of.row) != 0) {
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
        std::copy(of.values.begin(), of.values.end(), segment.values[of.row].begin());
    }
    for (const std::string& row : names) {
        if (segment.values.count(row) == 0) {
            throw UsageError(fmt::format("--row {}=..: {} needs its value", row, table.name));
        }
    }
    return segment;
}

/// Memory and clocks of the engine for the curve alone.
std::string engine_text(const ref::CurveTable& table, const CoreParameters& core) {
    try {
        const assembler::Assembly assembly = assembler::curve_program(table, core);
        const auto clocks = [&](const char* part) {
            return assembler::worst_case(assembly, table.name + "_" + part, {"idle"});
        };
        return fmt::format("engine: {} instructions; {} clocks a segment, {} a step, {} a sample\n",
                           assembly.placed().size() - 1, clocks("load"), clocks("step"),
                           clocks("sample"));
    } catch (const assembler::AssemblyError& error) {
        return fmt::format("engine: does not draw it: {}\n", error.what());
    }
}

std::string rows_text(const ref::CurveTable& table, const CoreParameters& core,
                      const ref::TableError* bound) {
    const auto orders = ref::order_demand(table, core.order, core.polynomial());
    std::string text = fmt::format("{:<16} {:>8} {:>10} {:>7}{}\n", "row", "bits", "range",
                                   "orders", bound != nullptr ? "    largest  spare bits" : "");
    for (const auto& [name, row] : table.rows) {
        if (row.line == 0 || row.same_as) continue;  // no line makes tau, nor what has another name
        const double range = row.range();
        const auto order = orders.find(name);
        text += fmt::format("{:<16} {:>8} {:>10} {:>7}", name + (row.of_axis ? "[k]" : ""),
                            core.coef_bits + row.fraction, fmt::format("+-{:g}", range),
                            order == orders.end() ? 0 : order->second);
        if (bound != nullptr) {
            const auto found = bound->largest.find(name);
            const double largest = found == bound->largest.end() ? 0 : found->second;
            text += largest > 0
                        ? fmt::format(" {:>10.4g} {:>11.1f}", largest, std::log2(range / largest))
                        : fmt::format(" {:>10} {:>11}", "-", "-");
        }
        text += "\n";
    }
    return text;
}

constexpr int kLeastFraction = -16;

/// Parameters that a table's words depend on.
constexpr std::array<std::string_view, 5> kOfTables{"Order", "CoefBits", "PositionBits",
                                                    "GuardBits", "Mode"};

CoreParameters core_of(const CurveOptions& asked) {
    CoreParameters core;
    core.aux_axes = 0;
    for (const ParameterList& list : asked.set) {
        if (std::find(kOfTables.begin(), kOfTables.end(), list.row->name) == kOfTables.end()) {
            throw UsageError(fmt::format("--set {}: a table's words depend on {} alone",
                                         list.row->name, fmt::join(kOfTables, ", ")));
        }
        list.set(core);
    }
    return core;
}

int curve_command(CurveOptions& asked) {
    const ref::CurveTable table = ref::read_curve_table(asked.file);
    const CoreParameters core = core_of(asked);
    const std::string title = fmt::format("{}: {}\n", table.name, table.title);
    if (asked.rows.empty()) {
        fmt::print("{}{}{}", title, rows_text(table, core, nullptr), engine_text(table, core));
        return 0;
    }
    const ref::TableError bound = ref::table_error(table, core, segment_of(table, asked));
    fmt::print("{}{}{}", title, rows_text(table, core, &bound), engine_text(table, core));
    for (const std::string& row : bound.beyond) {
        const int fraction = table.rows.at(row).fraction;
        const double needed = -2 - std::floor(std::log2(bound.largest.at(row)));
        fmt::print(stderr, "{}:{}: error: {} leaves its range: {}\n", table.file,
                   table.rows.at(row).line, row,
                   needed < kLeastFraction
                       ? "no fraction holds it"
                       : fmt::format("it needs a fraction of {:+}, not {:+}, or a shorter step",
                                     static_cast<int>(needed), fraction));
    }
    if (!bound.beyond.empty()) return 1;
    fmt::print(
        "error: {:.4g} length units at most on any axis, before the final rounding, in {} step{} "
        "of "
        "2^{} units\n",
        bound.worst(), asked.steps, asked.steps == 1 ? "" : "s", asked.step_exponent);
    return 0;
}

}  // namespace

void add_curve(CLI::App& app, int& status) {
    auto [command, asked] = add_command(
        app, status, "curve", "a curve's table: its rows, its cost, its error", curve_command);
    begin_group(command, group::kInput);
    add_choice(command, "ACTION", asked.action, kCurveActions,
               "{}: its rows, what the engine needs, "
               "and with --row the bound of a segment")
        ->required();
    add_text(command, "FILE", asked.file, "FILE.net", "the table")->required();
    begin_group(command, group::kCore);
    add_values(command, "--set", asked.set, "NAME=VALUE", "a parameter of the core",
               [](const std::string&, const std::string& text) { return single_parameter(text); });
    begin_group(command, group::kPlan);
    CLI::Option* const rows = add_values(
        command, "--row", asked.rows, "ROW=VALUE",
        "a row of the bus in the segment, ROW=X,Y,Z where it has axes; once for each row",
        row_values);
    add_value(command, "--step-exponent", asked.step_exponent, "K", "a step is 2^K length units",
              within(whole, 0, 27, "in [0, 27]"))
        ->needs(rows)
        ->default_val("20");
    add_value(command, "--down", asked.down, "S", "scale of the segment over that of a step, 2^S",
              within(whole, 0, 27, "in [0, 27]"))
        ->needs(rows)
        ->default_val("0");
    add_value(command, "--steps", asked.steps, "N", "steps of the segment",
              within(whole, 1, 100, "in [1, 100]"))
        ->needs(rows)
        ->default_val("1");
    command.footer("Exit status: 0; 1 a row leaves its range; 2 the input is wrong.");
}

}  // namespace curvecore::sysc
