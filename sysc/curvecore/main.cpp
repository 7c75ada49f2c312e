// SPDX-License-Identifier: Apache-2.0
// curvecore run | plan | words | stream | home | board | cam | join | compare | choose | explore:
// parts through the cores, from the command line.
//
// Exit status: 0 done and every check held; 1 a check failed; 2 the input or the command line is
// invalid, and nothing was written; 3 choose, explore: no configuration meets the request; 130
// interrupted, nothing written (compare: the finished rows are).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <system_error>

#include "ref/join/jumps.hpp"
#include "ref/join/least.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/board/board_command.hpp"
#include "sysc/commands/board/home_command.hpp"
#include "sysc/commands/board/stream_command.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/widths/choose_command.hpp"
#include "sysc/commands/widths/compare_command.hpp"
#include "sysc/commands/widths/explore_command.hpp"
#include "sysc/curvecore/cam_command.hpp"
#include "sysc/curvecore/command_options.hpp"
#include "sysc/curvecore/join_command.hpp"

namespace curvecore::sysc {
namespace {

void add_cam(CLI::App& command, RawOptions& raw, RawCamOptions& cam, CamOptions& options) {
    begin_group(command, group::kInput);
    command
        .add_option("TABLE", options.common.file,
                    "radii of the cutter's centre (.csv): 'x,0,7.5,..' (degrees), then a row per "
                    "section: x and radii in mm")
        ->type_name("")
        ->required();
    add_text(command, "--kappa", cam.kappa, "N",
             "half-turns of the spindle from section to section");
    add_text(command, "--scallop", cam.scallop, "LENGTH",
             "instead: height that the cutter may leave between turns");
    add_text(command, "--cutter", cam.cutter, "LENGTH", "radius of the cutter");
    add_text(command, "--surface", cam.surface, "NAME",
             fmt::format("through the radii: {}", fmt::join(ref::kSurfaceNames, ", ")));
    add_text(command, "--generatrix", cam.generatrix, "NAME",
             fmt::format("of tamm and blend: {}; parabola when left out",
                         fmt::join(ref::kGeneratrixNames, ", ")));
    add_text(command, "--ends", cam.ends, "NAME",
             "turn (default): once around the first and the last section too; helix: without");
    add_text(command, "--delta", cam.delta, "LENGTH",
             "how far a piece may be off the surface, along the radius");
    command
        .add_option("--against", options.against, "a finer table, to hold the drawn cam against")
        ->type_name("FINE.csv");
    add_text(command, "--feed", raw.feed, "SPEED", "over the surface: 1m/min, 20mm/s");
    add_surroundings(command, raw, options.common);
    add_timed_core(command, raw);
}

void add_join(CLI::App& command, RawOptions& raw, Options& options, RawJoinOptions& join) {
    begin_group(command, group::kInput);
    const char* const programs = "working path: G-code, or points (.csv)";
    command.add_option("A", join.a, programs)->type_name("");
    command.add_option("B", join.b, programs)->type_name("");
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const std::string& help) {
        command.add_option(name, text, help)->type_name(type);
    };
    add("--load", join.load, "FILE.json",
        "control points and all choices of a join.json; A and B if they are left out");
    add("--fit", join.fit, "NAME",
        fmt::format("curve through the control points: {}; default quintic",
                    fmt::join(ref::kJoinFitNames, ", ")));
    add("--points", join.points, "N", "control points, placed anew; default 3");
    add("--least", join.least, "WHAT",
        fmt::format("move them for the least {}", fmt::join(ref::kLeastNames, " or ")));
    add("--speed", join.speed, "LAW",
        fmt::format("from feed to feed: {}", fmt::join(ref::kSpeedLawNames, " (default) or ")));
    command.add_flag("--exact", join.exact,
                     "G5 and G5.2, in space with Z K R of this reader's own; default in XY");
    add("--tolerance", join.tolerance, "LENGTH", "G1 chords within this; default in space, 1um");
    add("--step", join.step, "LENGTH", "G1 chords of this path at most");
    add_interpreter(command, raw);
    add_surroundings(command, raw, options);
    add_timed_core(command, raw);
    add_run(command, raw, options);
}

void add_compare(CLI::App& command, RawOptions& raw, RawCompareOptions& compare,
                 CompareOptions& options) {
    add_input(command, raw, options.common, compare.feed, "LIST",
              fmt::format("of the schemes that step once a tick; {} if not given", kStandardFeeds));
    add_core(command, raw);
    begin_group(command, "Comparison");
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const std::string& help) {
        command.add_option(name, text, help)->type_name(type)->capture_default_str();
    };
    add("--curves", compare.curves, "NAME",
        fmt::format("without FILE, built-in curves: {}", fmt::join(kCurveSets, ", ")));
    add_list(command, "--set", compare.set, "NAME=LIST",
             fmt::format("values of a parameter, 4,6 or 4:8 or 4:8:2; {} if not given: {}",
                         fmt::join(kComparedSets, " "), ref::parameter_names()));
    add("--scheme", compare.scheme, "LIST",
        fmt::format("of splines, side by side: {}; the last three step once a tick",
                    fmt::join(kSchemeNames, ", ")));
    add("--tick", compare.tick, "LIST",
        fmt::format("their ticks: 10ms, 250us; {} if not given", kStandardTick));
    add("--segments", compare.segments, "TIMES",
        "segments that a plan may have, in times of those with the widest words");
    add("--samples", compare.samples, "N", "places at which each configuration is compared");
}

void add_choose(CLI::App& command, RawRequirement& raw, ChooseOptions& options) {
    begin_group(command, "Requirement");
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const std::string& help) {
        return command.add_option(name, text, help)->type_name(type)->capture_default_str();
    };
    add("--error", raw.error, "LENGTH",
        "worst error of a position on any axis, as the core gives it")
        ->required();
    add("--feed", raw.feed, "SPEED", "along the path, where acceleration lets it: 10m/min, 100mm/s")
        ->required();
    CLI::Option* const board =
        add("--board", raw.board, "NAME",
            "a motion_board with its UART on this board (scripts/boards) or a file of yours: its "
            "device, clock and sample period; or instead --device");
    add("--device", raw.device, "NAME", device_names());
    add("--radius", raw.radius, "LENGTH",
        "largest radius of arcs and helices; lines come with them");
    add("--least-radius", raw.least_radius, "LENGTH", "smallest radius; 10um when left out");
    add("--length", raw.length, "LENGTH", "longest spline");
    add("--travel", raw.travel, "LENGTH",
        "positions go so far to both sides; the largest radius or length when left out");
    add("--unit", raw.unit, "LENGTH",
        "length unit; the best of 1nm, 10nm, 0.1um and 1um when left out");
    add("--sample-rate", raw.sample_rate, "FREQUENCY", "samples a second")->excludes(board);
    add("--clock", raw.clock, "FREQUENCY", "that the core must run at; any when left out")
        ->excludes(board);
    add("--host-words", raw.host_words, "N", "words of 48 bits a second that the host can send");
    add("--build", raw.build, "BUILD", "parallel or serial; either when left out");
    command.add_option("--machine", options.machine, "acceleration and jerk from LinuxCNC's .ini")
        ->type_name("FILE.ini");
    begin_group(command, group::kOutput);
    command
        .add_option("-o,--output", options.folder,
                    "folder for choose.json, and core.json that --core takes")
        ->type_name("DIR");
    command
        .add_flag("--confirm", options.confirm,
                  "place and route the answer with scripts/synth.sh: minutes")
        ->excludes(board);
    command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
    command.footer(
        "Exit status: 0 there is one; 1 --confirm failed or is too slow; 2 the command line is "
        "wrong; "
        "3 no core keeps the requirement, and the answer says what to give up.");
}

int dispatch(const std::vector<std::string>& arguments) {
    CLI::App app{"Lines, arcs, helices and splines through FPGA interpolator cores", "curvecore"};
    app.set_version_flag("--version", "curvecore " CURVECORE_PROGRAM_VERSION);
    app.require_subcommand(1);
    begin_help(app);
    RawOptions raw;
    Options options;
    CLI::App* run = app.add_subcommand(
        "run",
        "plan FILE and run it through the Verilated RTL or another board; compare every sample");
    CLI::App* plan = app.add_subcommand(
        "plan", "the same without a board: segments, feed profile, predicted error and time");
    CLI::App* words =
        app.add_subcommand("words", "segment and profile words as memory files for $readmemh");
    for (CLI::App* command : {run, plan, words}) add_common(*command, raw, options);
    std::string words_for;
    words
        ->add_option("--to", words_for,
                     "for this board, which is asked for its core, clock, sample period and queues")
        ->type_name("BOARD");
    for (CLI::App* command : {run, plan}) add_report(*command, options);
    add_run(*run, raw, options);
    CLI::App* cam = app.add_subcommand(
        "cam", "a volumetric cam: TABLE of radii into a program, which runs as any part does");
    RawCamOptions raw_cam;
    CamOptions cam_options;
    add_cam(*cam, raw, raw_cam, cam_options);
    add_run(*cam, raw, cam_options.common);
    CLI::App* join = app.add_subcommand(
        "join", "an idle move between two working paths A and B: G-code, page to design it, run");
    RawJoinOptions raw_join;
    add_join(*join, raw, options, raw_join);
    CLI::App* compare = app.add_subcommand(
        "compare", "orders, widths and samplers through the bit-true kernel, side by side");
    RawCompareOptions raw_compare;
    CompareOptions compare_options;
    add_compare(*compare, raw, raw_compare, compare_options);
    CLI::App* choose = app.add_subcommand(
        "choose", "the smallest core that is proven to keep an error at a feed in a device");
    RawRequirement raw_requirement;
    ChooseOptions choose_options;
    add_choose(*choose, raw_requirement, choose_options);
    CLI::App* stream =
        app.add_subcommand("stream", "FILE to a board at the other end of a wire: steps and turns");
    RawWireOptions raw_wire;
    add_input(*stream, raw, options, raw.feed, "SPEED", kAlongPoints)->required();
    add_planning(*stream, raw);
    add_override(*stream, raw);
    add_wire(*stream, raw_wire);
    CLI::App* home = app.add_subcommand(
        "home", "the axes of such a board's machine to their switches: where they stand is known");
    RawHomeOptions raw_home;
    add_home(*home, raw_home, options);
    CLI::App* board = app.add_subcommand("board",
                                         "a virtual board that stream finds: the RTL of "
                                         "motion_board behind UDP");
    BoardOptions board_options;
    add_board(*board, board_options);
    CLI::App* explore = app.add_subcommand("explore", "the shortest queues that FILE needs");
    RawExplore raw_explore;
    add_common(*explore, raw_explore.common, options);
    add_explore(*explore, raw_explore);
    finish_help(app, arguments);
    check_names(app, arguments);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::Success& asked) {
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (*compare) {
        raw.path = "exact";  // the program's own curves
        if (compare_options.common.file.empty() && compare_options.common.folder.empty()) {
            compare_options.common.folder = "curves.out";
        }
        raw_compare.core_given = !raw.core.empty();
        if (raw_compare.scheme.empty() && !raw_compare.feed.empty()) raw.feed = raw_compare.feed;
        interpret(raw, compare_options.common);
        interpret(raw_compare, compare_options);
        return compare_command(std::move(compare_options));
    }
    if (*choose) {
        interpret(raw_requirement, choose_options);
        return choose_command(choose_options);
    }
    if (*cam) {
        interpret(raw, cam_options.common);
        interpret(raw_cam, cam_options);
        return cam_command(cam_options);
    }
    if (*board) return board_command(board_options);
    if (*explore) return explore_command(raw_explore, options);
    if (*join) options.file = "join.ngc";
    interpret(raw, options);
    if (*join) return join_command(options, raw_join);
    if (!words_for.empty()) plan_for(words_for, options);
    if (*run) return run_command(options);
    if (*stream) return stream_command(options, raw_wire);
    if (*home) return home_command(options, raw_home);
    return *plan ? plan_command(options) : words_command(options);
}

}  // namespace
}  // namespace curvecore::sysc

int main(int argc, char** argv) {
    try {
        return curvecore::sysc::dispatch(curvecore::sysc::asked_help({argv + 1, argv + argc}));
    } catch (const curvecore::ref::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    } catch (const curvecore::sysc::UsageError& error) {
        fmt::print(stderr, "curvecore: error: {}\n", error.what());
        return 2;
    } catch (const curvecore::sysc::Interrupted&) {
        return 130;
    } catch (const std::system_error& error) {  // a disk that is full
        fmt::print(stderr, "curvecore: error: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "curvecore: internal error: {}\n", error.what());
        return 1;
    }
}
