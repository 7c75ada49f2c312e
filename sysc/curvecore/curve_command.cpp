// SPDX-License-Identifier: Apache-2.0
// `curvecore curve`: a table of a curve (ref/curves/curve_table.hpp): its rows, what the engine
// needs for it, how far its words may be off a segment of it; its kernel; and the curve drawn as a
// part is.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "hls/curves/kernel_text.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/run_job.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/curvecore/asked_curve.hpp"
#include "sysc/curvecore/commands.hpp"
#include "sysc/curvecore/curve_check.hpp"
#include "sysc/curves/named_table.hpp"

namespace curvecore::sysc {
namespace {

RowValues row_values(const std::string& option, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw UsageError(fmt::format("{} '{}': expected ROW=VALUE or ROW=X,Y,Z", option, text));
    }
    return {text.substr(0, equals), list_of(plain_number)(option, text.substr(equals + 1))};
}

constexpr int kLeastFraction = -16;

/// Checks that the core is one of those that a table's lines are rounded for.
void check_core(const CoreParameters& core) {
    if (core.anchor != 0 && core.parameter_guard == 0) return;
    throw UsageError("--set: a table is drawn with Anchor=1 and ParameterGuard=0");
}

int check(CurveOptions& asked) {
    if (asked.has_formulas()) throw UsageError("--x --y --z: of run and derive");
    const std::string folder = asked.part.options.folder;  // empty: no curve.json
    const std::string file = table_file("FILE", asked.part.options.file);
    const ref::CurveTable table = ref::read_curve_table(file);
    const Options& options = asked.part.complete();
    check_core(options.core);
    std::optional<ref::TableSegment> segment;
    if (!asked.rows.empty()) {
        segment.emplace();
        segment->values = rows_of(table, asked);
        segment->k = asked.step_exponent;
        segment->lambda = asked.step_exponent + asked.down;
        segment->steps = asked.steps;
    }
    const CurveCheck made = check_curve(table, options.core, segment);
    if (!folder.empty()) {
        OutputFolder to(folder);
        to.write("curve.json", made.json().dump(1) + "\n");
        to.commit();
    }
    if (options.json) {
        print_json(made.json());
    } else {
        fmt::print("{}", made.text());
    }
    if (!made.bound) return 0;
    const ref::TableError& bound = *made.bound;
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
    if (!std::isfinite(bound.worst())) {
        fmt::print(stderr,
                   "{}: error: a series does not shrink in such steps, so nothing bounds what it "
                   "leaves out: take a shorter step\n",
                   table.file);
        return 1;
    }
    if (options.json) return 0;
    fmt::print(
        "error: {:.4g} length units at most on any axis, before the final rounding, in {} step{} "
        "of "
        "2^{} units\n",
        bound.worst(), asked.steps, asked.steps == 1 ? "" : "s", asked.step_exponent);
    return 0;
}

/// Draws the curve as a program of one move.
int run(CurveOptions& asked) {
    PartOptions& part = asked.part;
    const NamedCurve curve = named_curve(asked);
    part.options.gcode.table = curve.table;
    Options options = part.complete();
    check_core(options.core);
    ref::HeldProgram program;
    program.file = curve.table->file;
    program.moves.push_back(move_along(curve));
    program.moves.back().feed = asked.feed;
    options.program = std::make_shared<const ref::HeldProgram>(std::move(program));
    Runner runner(std::move(options));
    OutputFolder folder(runner.job().options.folder);
    RunExtras extras;
    if (!curve.text.empty()) {
        extras.finish = [&curve](const Report&, OutputFolder& to) {
            to.write(curve.table->file, curve.text);
            return true;
        };
    }
    return runner.run(folder, extras);
}

/// Writes the table of formulas, and says how a program names the curve.
int derive(CurveOptions& asked) {
    const NamedCurve curve = derived(asked);
    const ref::Move move = move_along(curve);
    const std::string& file = asked.part.options.file;
    if (std::filesystem::path(file).extension() != ".net") {
        throw UsageError(fmt::format("FILE '{}': a table is NAME.net", file));
    }
    std::error_code unknown;
    if (std::filesystem::is_regular_file(file, unknown) &&
        ref::read_text_file(file) != curve.text) {
        throw UsageError(fmt::format(
            "FILE '{}': it is there, and not of these formulas: take another name", file));
    }
    std::ofstream out(file);
    out << curve.text;
    out.close();
    if (!out) throw UsageError(fmt::format("cannot write {}", file));
    std::string comment = fmt::format("(curve, {}", curve.table->name);
    for (const auto& [row, values] : curve.rows) {
        comment += fmt::format(", {}={:.12g}", row, values[0]);
        if (!curve.table->rows.at(row).of_axis) continue;
        comment += fmt::format(" {:.12g} {:.12g}", values[1], values[2]);
    }
    fmt::print("G1 X{:.6f} Y{:.6f} Z{:.6f}\n{}, length={:.9f})\nG1 X{:.6f} Y{:.6f} Z{:.6f}\n",
               move.start.x(), move.start.y(), move.start.z(), comment, curve.length, move.end.x(),
               move.end.y(), move.end.z());
    return 0;
}

/// Prints the table's kernel, as a header of C++.
int kernel(CurveOptions& asked) {
    if (asked.has_formulas()) throw UsageError("--x --y --z: of run and derive");
    const std::string file = table_file("FILE", asked.part.options.file);
    const std::string text = ref::read_text_file(file);
    fmt::print("{}", hls::kernel_text(ref::read_network_text(file, text), text));
    return 0;
}

int curve_command(CurveOptions& asked) {
    const bool result = asked.action == CurveAction::kCheck || asked.action == CurveAction::kRun;
    if (asked.part.options.json && !result) throw UsageError("--json: of run and check");
    if (asked.action == CurveAction::kKernel) return kernel(asked);
    if (asked.action == CurveAction::kDerive) return derive(asked);
    return asked.action == CurveAction::kCheck ? check(asked) : run(asked);
}

}  // namespace

void add_curve(CLI::App& app, int& status) {
    auto [command, asked] = add_command(
        app, status, "curve",
        "a curve's table: its rows, its cost, its error; the curve drawn as a part", curve_command);
    begin_group(command, group::kInput);
    add_choice(command, "ACTION", asked.action, kCurveActions,
               "{}; check: its rows, what the engine needs, and with --row the bound of a segment; "
               "run: draws it and compares every sample, as the command run does; derive: writes "
               "the table of formulas, and says how a program names it; kernel: prints it as a "
               "kernel of C++, over hls/curves/curve_steps.hpp")
        ->required();
    add_text(command, "FILE", asked.part.options.file, "FILE.net",
             "the table, or the name of one in ref/curves; with formulas one that is not there")
        ->required();
    for (const auto& [name, text] :
         {std::pair("--x", &asked.x), std::pair("--y", &asked.y), std::pair("--z", &asked.z)}) {
        add_text(command, name, *text, "FORMULA",
                 fmt::format("of run and derive: {} of the curve, mm, by t", name + 2));
    }
    add_value(command, "--t", asked.formula, "FROM,TO", "of formulas: t at both ends",
              [&formula = asked.formula](const std::string& option, const std::string& text) {
                  const std::vector<double> ends = list_of(plain_number)(option, text);
                  if (ends.size() != 2 || !(ends[0] < ends[1])) {
                      throw UsageError(option + ": expected FROM,TO, from less to more");
                  }
                  ref::CurveFormula made = formula;
                  made.from = ends[0];
                  made.to = ends[1];
                  return made;
              });
    add_values(command, "--let", asked.constants, "NAME=VALUE", "a number that formulas name",
               row_values);
    CLI::Option* const rows = add_values(
        command, "--row", asked.rows, "ROW=VALUE",
        "a row of the bus at the start, ROW=X,Y,Z where it has axes, once for each row; of check "
        "in steps, of run where the path is 1 mm long",
        row_values);
    begin_group(command, group::kPlan);
    add_value(command, "--length", asked.length, "LENGTH", "of run: of the curve",
              in_range(length, 1e-3, 1e6))
        ->needs(rows);
    add_value(command, "--start", asked.start, "X,Y,Z", "of run: mm; default 0,0,0",
              list_of(plain_number));
    add_value(command, "--feed", asked.feed, "SPEED", "of run, along the curve: 1m/min, 20mm/s",
              speed)
        ->default_val("1m/min");
    add_value(command, "--step-exponent", asked.step_exponent, "K",
              "of check: a step is 2^K length units", within(whole, 0, 27, "in [0, 27]"))
        ->needs(rows)
        ->default_val("20");
    add_value(command, "--down", asked.down, "S",
              "of check: scale of the segment over that of a step, 2^S",
              within(whole, 0, 27, "in [0, 27]"))
        ->needs(rows)
        ->default_val("0");
    add_value(command, "--steps", asked.steps, "N", "of check: steps of the segment",
              within(whole, 1, 100, "in [1, 100]"))
        ->needs(rows)
        ->default_val("1");
    add_surroundings(command, asked.part);
    add_timed_core(command, asked.part);
    add_report(command, asked.part);
    add_drawing(command, asked.part);
    command.footer(
        "Exit status: 0; 1 a row leaves its range, or a check failed; 2 the input is "
        "wrong.");
}

}  // namespace curvecore::sysc
