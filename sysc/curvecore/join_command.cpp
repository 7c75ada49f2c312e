// SPDX-License-Identifier: Apache-2.0
// `curvecore join`: an idle move between two working paths.
#include <fmt/format.h>

#include <stdexcept>

#include "ref/join/jumps.hpp"
#include "ref/join/least.hpp"
#include "ref/limits/travel.hpp"
#include "ref/program/gcode_reader.hpp"
#include "ref/program/program_reader.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/run_job.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/curvecore/commands.hpp"
#include "sysc/join/join_page.hpp"

namespace curvecore::sysc {
namespace {

using ref::Program;

/// Choices that are not given are those of the loaded file, or the defaults.
struct JoinOptions {
    PartOptions part;
    std::string a, b;
    std::string load;  // join.json; empty: not given
    std::optional<ref::JoinFit> fit;
    std::optional<int> points;
    std::optional<ref::Least> least;
    std::optional<ref::SpeedLaw> speed;
    std::optional<double> tolerance, step;  // mm
    bool exact = false;
};

constexpr double kSameEnd = 1e-6;  // mm, 1: equal ends of a loaded move and of the programs
constexpr int kUsualPoints = 3;    // as in [Petrakov], fig. 1

Program working_path(const std::string& name, bool before, const Options& options,
                     const ref::Machine& machine) {
    Program program = ref::read_program(name, {}, options.open_program, options.gcode);
    program = before ? ref::until_last_working_move(std::move(program))
                     : ref::from_first_working_move(std::move(program));
    if (program.moves.front().length() == 0) program.moves.erase(program.moves.begin());  // a dwell
    for (const ref::Move& move : program.moves) {
        const std::string beyond = ref::beyond_travel(ref::travel(move), move, machine);
        if (!beyond.empty()) throw ref::InputError(name, move.line, beyond);
    }
    return program;
}

/// Checks that the programs' ends are apart, and that auxiliary axes stand still between them.
void check_ends(const Program& a, const Program& b) {
    const ref::Move& last = a.moves.back();
    const ref::Move& first = b.moves.front();
    if ((last.end - first.start).norm() < ref::kStill) {
        throw ref::InputError(
            b.file, first.line,
            fmt::format("begins where {} ends: there is nothing to join", a.file));
    }
    for (std::size_t i = 0; i < ref::kAuxAxes; ++i) {
        if (std::abs(last.aux_end[i] - first.aux_start[i]) < ref::kStill) continue;
        throw ref::InputError(
            b.file, first.line,
            fmt::format("{} begins at {:g}, {} leaves it at {:g}: an idle move is "
                        "of X Y Z alone",
                        ref::kAxisLetters[3 + i], first.aux_start[i], a.file, last.aux_end[i]));
    }
}

void check_loaded(const std::string& file, const ref::Joint& loaded, const ref::Joint& now,
                  const char* which, const std::string& program) {
    if ((loaded.position - now.position).norm() <= kSameEnd &&
        (loaded.tangent - now.tangent).norm() <= kSameEnd) {
        return;
    }
    throw ref::InputError(
        file, 0,
        fmt::format("was made for another {}: {} is elsewhere now, or goes another "
                    "way",
                    which, program));
}

int point_count(const std::string& option, const std::string& text) {
    const double count = plain_number(option, text);
    if (count >= 0 && count <= static_cast<double>(kMostJoinPoints) && count == std::floor(count)) {
        return static_cast<int>(count);
    }
    throw UsageError(
        fmt::format("{} '{}': must be a whole number in [0, {}]", option, text, kMostJoinPoints));
}

void choose_gcode(const JoinOptions& asked, bool loaded, JoinFile& file) {
    const int given =
        int{asked.exact} + int{asked.tolerance.has_value()} + int{asked.step.has_value()};
    if (given > 1) throw UsageError("--exact, --tolerance and --step exclude each other");
    if (asked.tolerance) {
        file.gcode = {ref::GcodeForm::kTolerance, *asked.tolerance};
    } else if (asked.step) {
        file.gcode = {ref::GcodeForm::kStep, *asked.step};
    } else if (asked.exact || (!loaded && ref::is_plane(file.move.pieces()))) {
        file.gcode = {};
    } else if (!loaded) {
        file.gcode = {ref::GcodeForm::kTolerance, 1e-3};
    }
}

JoinFile design(const JoinOptions& asked, JoinFile file, const Program& a, const Program& b) {
    const bool loaded = !asked.load.empty();
    const ref::Joint start = ref::joint_of(a.file, a.moves.back(), true);
    const ref::Joint end = ref::joint_of(b.file, b.moves.front(), false);
    file.move.fit = asked.fit.value_or(file.move.fit);
    file.law = asked.speed.value_or(file.law);
    if (loaded && !asked.points) {
        check_loaded(asked.load, file.move.start, start, "start", a.file);
        check_loaded(asked.load, file.move.end, end, "end", b.file);
        file.move.start = start;
        file.move.end = end;
    } else {
        file.move =
            ref::default_idle_move(start, end, file.move.fit, asked.points.value_or(kUsualPoints));
    }
    if (asked.least) {
        try {
            file.move = ref::with_least(file.move, *asked.least);
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format(
                "--least {}: {}", ref::kLeastNames.at(static_cast<std::size_t>(*asked.least)),
                error.what()));
        }
    }
    const std::string flaw = flaw_of(file.move);
    if (!flaw.empty()) throw ref::InputError(b.file, b.moves.front().line, flaw);
    choose_gcode(asked, loaded, file);
    return file;
}

std::string blocks_of(const JoinFile& file) {
    const ref::PathTable path(file.move.pieces());
    try {
        return ref::idle_gcode(path, file.course(path.length()), file.gcode);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

std::string joint_row(const char* where, const ref::Jump& jump) {
    const std::string slope =
        jump.slope > 0 ? fmt::format("corner of {:.3g} degrees, ", jump.slope * 180 / M_PI) : "";
    return fmt::format(
        "  {:<18}{}curvature jumps by {:.3g} /mm, acceleration by {:.3g} g across and "
        "{:.3g} g along the path\n",
        where, slope, jump.curvature, jump.across, jump.along);
}

void print_design(const JoinFile& file) {
    const ref::JoinJumps found = ref::jumps(file.move, file.law);
    fmt::print("idle move: {}, {} control points, {:.6g} mm, {:.4g} to {:.4g} m/min\n", found.name,
               file.move.points.size(), found.length, file.move.start.feed * 0.06,
               file.move.end.feed * 0.06);
    fmt::print("{}{}", joint_row("behind path 1", found.start),
               joint_row("before path 2", found.end));
    const ref::Jump inside = ref::worst_inside(file.move, file.law);
    if (inside.slope + inside.curvature > 0) fmt::print("{}", joint_row("at its points", inside));
}

/// Designs the move, writes join.ngc, join.json and join.html, and runs join.ngc as `run` does.
int join_command(JoinOptions& asked) {
    asked.part.options.file = "join.ngc";
    const Options& options = asked.part.complete();
    JoinFile file;
    if (!asked.load.empty()) file = read_join_file(asked.load);
    if (!asked.a.empty()) file.a = asked.a;
    if (!asked.b.empty()) file.b = asked.b;
    if (file.a.empty() || file.b.empty()) {
        throw UsageError("join wants two programs, A and B, or --load FILE.json");
    }
    const ref::Machine machine = machine_of(options);
    refuse_joints(machine, "join");
    const Program a = working_path(file.a, true, options, machine);
    const Program b = working_path(file.b, false, options, machine);
    check_ends(a, b);
    file = design(asked, std::move(file), a, b);

    const JoinProgram program = join_program(a, b);
    const std::string text = program.with(blocks_of(file));
    Program joined = ref::read_gcode_text(
        text, "join.ngc", {options.points.fit_tolerance, ref::Dialect::kLinuxcnc, {}});
    joined.warnings.insert(joined.warnings.begin(), b.warnings.begin(), b.warnings.end());
    joined.warnings.insert(joined.warnings.begin(), a.warnings.begin(), a.warnings.end());
    Options drawn = options;
    drawn.program =
        std::make_shared<const ref::HeldProgram>(ref::HeldProgram{std::move(joined), {}, {}});
    Runner runner(std::move(drawn));
    OutputFolder folder(options.folder);
    if (!options.quiet && !options.json) print_design(file);
    folder.write("join.ngc", text);
    folder.write("join.json", file.text());
    folder.write("join.html", join_html(file, a, b, program));
    return runner.run(folder);
}

}  // namespace

void add_join(CLI::App& app, int& status) {
    auto [command, join] = add_command(
        app, status, "join",
        "an idle move between two working paths A and B: G-code, page to design it, run",
        join_command);
    begin_group(command, group::kInput);
    const char* const programs = "working path: G-code, or points (.csv)";
    add_text(command, "A", join.a, "", programs);
    add_text(command, "B", join.b, "", programs);
    add_text(command, "--load", join.load, "FILE.json",
             "control points and all choices of a join.json; A and B if they are left out");
    add_choice(command, "--fit", join.fit, ref::kJoinFitNames,
               "curve through the control points: {}; default quintic");
    add_value(command, "--points", join.points, "N", "control points, placed anew; default 3",
              point_count);
    add_choice(command, "--least", join.least, ref::kLeastNames, "move them for the least {}",
               "WHAT", " or ");
    add_choice(command, "--speed", join.speed, ref::kSpeedLawNames, "from feed to feed: {}", "LAW",
               " (default) or ");
    command.add_flag("--exact", join.exact,
                     "G5 and G5.2, in space with Z K R of this reader's own; default in XY");
    add_value(command, "--tolerance", join.tolerance, "LENGTH",
              "G1 chords within this; default in space, 1um", in_range(length, 1e-6, 10));
    add_value(command, "--step", join.step, "LENGTH", "G1 chords of this path at most",
              in_range(length, 1e-6, 1e4));
    add_interpreter(command, join.part);
    add_surroundings(command, join.part);
    add_timed_core(command, join.part);
    add_drawing(command, join.part);
}

}  // namespace curvecore::sysc
