// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/options/part_options.hpp"

#include <filesystem>

#include "ref/curve/joint_path.hpp"
#include "ref/machine/machine.hpp"
#include "ref/program/program_reader.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/curves/named_table.hpp"
#include "sysc/job/linuxcnc_program.hpp"

namespace curvecore::sysc {
namespace {

/// Checks a path of RTL: make_core.sh and Verilator's make take plain names.
void check_name(const std::string& option, const std::string& path) {
    const std::size_t at = path.find_first_of(" \t\n*?[]\\$`'\"#%;&|<>()");
    if (at == std::string::npos) return;
    throw UsageError(fmt::format("{} '{}': no file of RTL can be read whose path has a '{}'",
                                 option, path, path[at]));
}

/// Reads the folder of a core's sources.
std::string folder_of_rtl(const std::string& option, const std::string& text) {
    namespace fs = std::filesystem;
    std::error_code unknown;
    const fs::path folder = fs::canonical(text, unknown);
    if (unknown || !fs::exists(folder / "motion_interpolator.sv", unknown)) {
        throw UsageError(fmt::format("{} '{}': there is no motion_interpolator.sv", option, text));
    }
    check_name(option, folder);
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_directory() || entry.path().extension() == ".sv") {
            check_name(option, entry.path());
        }
    }
    return folder;
}

/// Reads a file of a design of others.
std::string file_of_dut(const std::string& option, const std::string& text) {
    namespace fs = std::filesystem;
    std::error_code unknown;
    const fs::path file = fs::canonical(text, unknown);
    if (unknown || !fs::is_regular_file(file, unknown)) {
        throw UsageError(fmt::format("{} '{}': there is no such file", option, text));
    }
    check_name(option, file);
    return file;
}

constexpr double kArcTolerance = 1e-3;  // mm
constexpr int kMostThreads = 64;
constexpr std::array<std::string_view, 2> kPathNames{"program", "exact"};
constexpr std::array<std::string_view, 2> kInterpreterNames{"curvecore", "linuxcnc"};

void check_points(const Options& options) {
    const ref::PointsOptions& points = options.points;
    const ref::PointsOptions unset;
    if (points.ends != unset.ends && points.fit != ref::Fit::kC2) {
        throw UsageError("--ends is for --fit c2");
    }
    const bool fit = points.fit != unset.fit && points.fit != ref::Fit::kArcs;
    const bool asked =
        fit || points.parametrisation != unset.parametrisation || points.feed != unset.feed;
    if (asked && !ref::is_points_file(options.file)) {
        throw UsageError("--fit but for arcs, --parametrisation and --feed are for points (.csv)");
    }
}

/// Interpreter of the program, unless it is this program's own reader.
ref::OpenProgram open_program(const PartOptions& part) {
    const Options& options = part.options;
    if (!part.linuxcnc) return {};
    if (ref::is_points_file(options.file) || options.file == ref::kStandardInput) {
        throw UsageError("--interpreter linuxcnc is for files of G-code");
    }
    return [ini = options.machine, tools = part.tools,
            within = options.points.fit_tolerance](const std::string& file) {
        return open_linuxcnc(file, {ini, tools}, within);
    };
}

/// Sets the state that a program begins with; LinuxCNC's interpreter reads it from its own files.
void set_start(const PartOptions& part, Options& options) {
    const bool points = ref::is_points_file(options.file);
    if (points && (!part.tools.empty() || part.radii_tolerance)) {
        throw UsageError("--tools and --arc-tolerance are for G-code");
    }
    if (options.open_program && part.radii_tolerance) {
        throw UsageError("--arc-tolerance or --interpreter: LinuxCNC has its own tolerance");
    }
    if (points || options.open_program || options.file.empty()) return;
    ref::ProgramStart& start = options.gcode.start;
    start = ref::read_program_start(options.machine, part.tools);
    if (part.radii_tolerance) start.arc_tolerance = *part.radii_tolerance;
    if (options.machine.empty()) return;
    const ref::Machine machine = ref::read_machine(options.machine);
    if (const auto home = machine.of_tool().home) std::copy_n(home->data(), 3, start.place.data());
    if (const auto* table = std::get_if<ref::TiltingTable>(&machine.kinematics)) {
        start.tool_length = table->tool_length;
    }
}

/// Lets the block of the interpolator be that of the board.
void take_interpolator(Options& options) {
    options.system.interpolator = options.needs_rtl() ? BlockKind::kRtl : BlockKind::kKernel;
}

/// Sets the system's blocks; the board is that of the interpolator.
void take_system(const std::vector<std::string>& texts, Options& options) {
    if (!options.in_system()) throw UsageError("--system is for --on systemc and systemc-rtl");
    take_interpolator(options);
    for (const std::string& text : texts) set_system(options.system, text);
    options.board = options.system.interpolator == BlockKind::kRtl ? BoardKind::kSystemcRtl
                                                                   : BoardKind::kSystemc;
}

/// Returns the table that the core draws: that of joints, where the machine has some; null: none.
std::shared_ptr<const ref::CurveTable> drawn_table(const Options& options) {
    const bool machine = !options.machine.empty() && !options.file.empty();
    if (!machine || ref::is_trivial(ref::read_machine(options.machine).kinematics)) {
        return options.gcode.table;
    }
    if (options.gcode.table) {
        throw UsageError("--curve: the core draws this machine's joints, no other table");
    }
    return named_table("series");
}

/// Checks that a core draws tables.
void check_table_core(const Options& options) {
    if (!options.gcode.table && options.core.order > ref::kJointOrders) {
        throw UsageError(fmt::format("--machine: joints are drawn with Order 2 .. {}, not {}",
                                     ref::kJointOrders, options.core.order));
    }
    if (options.core.build == Build::kEngine) return;
    throw UsageError(options.gcode.table ? "--curve: a table is drawn by --build engine"
                                         : "--machine: joints are drawn by --build engine");
}

}  // namespace

const Options& PartOptions::complete() {
    if (options.folder.empty()) {
        options.folder = (options.file == ref::kStandardInput ? "stdin" : options.file) + ".out";
    }
    check_points(options);
    options.open_program = open_program(*this);
    set_start(*this, options);
    if (options.gcode.dialect && options.open_program) {
        throw UsageError("--dialect or --interpreter: LinuxCNC reads its own");
    }
    if (options.points.fit == ref::Fit::kArcs) {
        options.arc_tolerance = options.arc_tolerance.value_or(kArcTolerance);
    } else if (options.arc_tolerance) {
        throw UsageError("--tolerance is for --fit arcs");
    }
    if (options.gcode.table && options.open_program) {
        throw UsageError("--curve or --interpreter: LinuxCNC's does not know the comment");
    }
    const std::shared_ptr<const ref::CurveTable> table = drawn_table(options);
    if (table && !core.build && core.core.empty() && core.board.empty()) {
        core.build = Build::kEngine;  // which alone draws tables
    }
    core.apply(options);
    if (table) check_table_core(options);
    ref::add_table(table, options.core);
    take_interpolator(options);
    if (!options.needs_rtl() && options.stall_seed) {
        throw UsageError("--stall is for --on rtl and systemc-rtl");
    }
    if (options.trace && options.board == BoardKind::kKernel) {
        throw UsageError("--trace is for --on rtl, systemc and systemc-rtl");
    }
    return options;
}

void add_interpreter(CLI::App& command, PartOptions& part) {
    add_value(command, "--interpreter", part.linuxcnc, "NAME",
              "of G-code: curvecore, or linuxcnc: LinuxCNC's own, which must be installed, with "
              "the tools and parameters that --machine names",
              one_of<bool>(kInterpreterNames))
        ->default_val("curvecore");
    add_choice(command, "--dialect", part.options.gcode.dialect, ref::kDialectNames,
               "of G-code: {}; recognised when left out");
    add_text(command, "--tools", part.tools, "FILE.tbl",
             "lengths of tools, LinuxCNC's table; that of --machine's .ini when left out");
    add_value(command, "--arc-tolerance", part.radii_tolerance, "LENGTH",
              "by how much an arc's radii may differ; LinuxCNC's tolerance when left out",
              in_range(length, 1e-6, 1000))
        ->group(group::kRare);
}

void add_surroundings(CLI::App& command, PartOptions& part) {
    begin_group(command, group::kOutput);
    add_text(command, "-o,--output", part.options.folder, "DIR",
             "folder for the results; FILE.out when left out");
    command.add_flag("-q,--quiet", part.options.quiet, "print warnings and errors only");
    add_json(command, part.options.json);
    begin_group(command, group::kPlan);
    add_text(command, "--machine", part.options.machine, "FILE.ini", "limits from LinuxCNC's .ini");
    begin_group(command, group::kCore);
    add_value(command, "--unit", part.core.said.unit_mm, "LENGTH",
              "length unit: 2.5um, 1/65536in; default 1nm", unit_of);
}

CLI::Option* add_file(CLI::App& command, PartOptions& part) {
    begin_group(command, group::kInput);
    Options& options = part.options;
    CLI::Option* file = add_text(command, "FILE", options.file, "",
                                 "G-code (.ngc .nc .gcode .tap ..) or points (.csv); - reads "
                                 "G-code from standard input");
    add_choice(command, "--fit", options.points.fit, ref::kFitNames,
               "spline through points: {}; arcs: tangent arcs instead of splines, of "
               "G-code too");
    add_value(command, "--tolerance", options.arc_tolerance, "LENGTH",
              "of --fit arcs: how far they may be off the splines; default 1um",
              in_range(length, 1e-6, 10))
        ->group(group::kRare);
    add_choice(command, "--ends", options.points.ends, ref::kEndsNames, "of --fit c2: {}")
        ->group(group::kRare);
    add_choice(command, "--parametrisation", options.points.parametrisation,
               ref::kParametrisationNames, "of that spline: {}")
        ->group(group::kRare);
    add_interpreter(command, part);
    add_value(command, "--curve", options.gcode.table, "NAME",
              "the curve that comments (curve, NAME, ROW=.., length=..) name: FILE.net, or a table "
              "of ref/curves",
              [](const std::string&, const std::string& text) { return named_table(text); });
    return file;
}

void add_feed(CLI::App& command, PartOptions& part, const char* along) {
    add_value(command, "--feed", part.options.points.feed, "SPEED", along, speed)
        ->default_val("1m/min");
}

CLI::Option* add_input(CLI::App& command, PartOptions& part) {
    CLI::Option* file = add_file(command, part);
    add_feed(command, part);
    add_surroundings(command, part);
    return file;
}

void add_planning(CLI::App& command, PartOptions& part) {
    begin_group(command, group::kPlan);
    add_choice(command, "--effort", part.options.effort, ref::kEffortNames, "of the feed: {}")
        ->group(group::kRare);
    add_choice(command, "--holds", part.options.holds, ref::kHoldNames,
               "how a hold stops, by words for every place or slowly: {}");
    add_value(command, "--full-s", part.options.rules.full, "S",
              "S at which the level of the outputs is whole",
              within(plain_number, kAboveZero, kGreatest, "above 0"))
        ->default_val("1000");
    add_value(command, "--full-q", part.options.rules.full_q, "Q",
              "Q of M67 and M68 E0 at which it is; they set it then, not S",
              within(plain_number, kAboveZero, kGreatest, "above 0"));
    command.add_flag("--laser", part.options.rules.laser,
                     "outputs of a laser: no level in rapids; with M4 it follows the speed, whole "
                     "at the feed");
    command.add_flag("--dark-at-rest", part.options.rules.dark_at_rest,
                     "with --laser and M3: no level in holds and dwells, either");
    add_value(
        command, "--from", part.options.from_mm, "LENGTH",
        "draws the rest of the path, from there on along it, with the outputs as they are there",
        in_range(length, 0, kGreatest))
        ->group(group::kRare);
    add_value(command, "--threads", part.options.threads, "N",
              "that plan; what they make is the same for any number", whole_in(1, kMostThreads))
        ->default_val("2")
        ->group(group::kRare);
    add_value(command, "--path", part.options.exact_path, "NAME",
              "program: within the tolerance that G64 allows; exact", one_of<bool>(kPathNames))
        ->default_val("program");
}

void add_override(CLI::App& command, PartOptions& part) {
    begin_group(command, group::kPlan);
    const auto percent = [](const std::string& option, const std::string& text) {
        return quantity(option, text, {{"", 0}, {"%", 0}});
    };
    add_value(command, "--override", part.options.override_percent, "PERCENT",
              "feed override, 1 to 200: up to 100 time is scaled, above it feeds are planned "
              "higher, as far as limits allow",
              within(percent, 1, kMostOverride, "in [1, 200] percent"))
        ->default_val("100");
}

void add_timed_core(CLI::App& command, PartOptions& part, const TimedValues& values) {
    add_core(command, part.core);
    add_clocks(command, part.core, part.options, values);
    add_planning(command, part);
}

void add_common(CLI::App& command, PartOptions& part, const TimedValues& values) {
    add_input(command, part)->required();
    add_timed_core(command, part, values);
}

void add_report(CLI::App& command, PartOptions& part) {
    command
        .add_flag_callback(
            "--no-segments", [&part] { part.options.segments_file = false; },
            "segments.json is not written: it has a kilobyte of every segment")
        ->group(group::kRare);
    command.add_flag("--junit", part.options.junit, "junit.xml: each check a test case, for CI")
        ->group(group::kRare);
}

void add_drawing(CLI::App& command, PartOptions& part) {
    Options& options = part.options;
    add_override(command, part);
    begin_group(command, group::kBoard);
    add_choice(command, "--on", options.board, kBoardNames, "board: {}")->type_name("BOARD");
    add_value(command, "--rtl", options.rtl, "FOLDER",
              "sources of the RTL, in place of the program's: a copy of rtl/ with changes of yours",
              folder_of_rtl);
    add_values(command, "--dut", options.dut, "FILE.v",
               "a design of yours with the ports of rtl/motion_interpolator.sv, in place of the "
               "core; once for each of its files",
               file_of_dut);
    command
        .add_option_function<std::vector<std::string>>(
            "--system",
            [&options](const std::vector<std::string>& texts) { take_system(texts, options); },
            "of --on systemc: " + system_names())
        ->type_name("NAME=VALUE,..")
        ->allow_extra_args(false)
        ->take_all()
        ->delimiter(',')
        ->group(group::kRare);
    add_value(command, "--stall", options.stall_seed, "SEED",
              "random stalls on every handshake of the RTL; the samples must not change", whole)
        ->group(group::kRare);
    command.add_flag("--trace", options.trace,
                     "waves.fst of the RTL, system.vcd of pins and axes, and their .gtkw");
    const auto rows = [](const std::string& option, const std::string& text) {
        const std::uint64_t number = whole(option, text);
        if (number == 0) throw UsageError(option + " must be at least 1");
        return number;
    };
    add_value(command, "--rows", options.most_rows, "N",
              fmt::format("of samples.csv at most, default {}: of more samples every n-th; all are "
                          "checked",
                          options.most_rows),
              rows)
        ->group(group::kRare);
    add_value(command, "--trace-clocks", options.trace_clocks, "N", "clocks in the waveform", whole)
        ->default_val(options.trace_clocks)
        ->group(group::kRare);
}

Options read_part_options(std::vector<std::string> arguments,
                          const std::function<void(CLI::App&, PartOptions&)>& more) {
    CLI::App app;
    app.require_subcommand(1);
    begin_help(app);
    PartOptions part;
    Options options;
    CLI::App& plan = *app.add_subcommand("plan", "");
    add_common(plan, part);
    if (more) more(plan, part);
    plan.callback([&] { options = part.complete(); });
    arguments.insert(arguments.begin(), "plan");
    parse(app, std::move(arguments));
    options.quiet = true;
    return options;
}

}  // namespace curvecore::sysc
