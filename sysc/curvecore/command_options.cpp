// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/command_options.hpp"

#include <fmt/format.h>

#include "sysc/commands/terminal/help.hpp"
#include "sysc/cost/device.hpp"

namespace curvecore::sysc {
namespace {

constexpr const char* kFileOut = "folder for the results; FILE.out when left out";

}  // namespace

CLI::Option* add_text(CLI::App& command, const char* name, std::string& text, const char* type,
                      const std::string& help) {
    return command.add_option(name, text, help)->type_name(type)->capture_default_str();
}

CLI::Option* add_list(CLI::App& command, const char* name, std::vector<std::string>& list,
                      const char* type, const std::string& help) {
    CLI::Option* option = command.add_option(name, list, help)->type_name(type);
    return option->allow_extra_args(false)->take_all();
}

void add_interpreter(CLI::App& command, RawOptions& raw) {
    add_text(command, "--interpreter", raw.interpreter, "NAME",
             "of G-code: curvecore, or linuxcnc: LinuxCNC's own, which must be installed, with the "
             "tools and parameters that --machine names");
    add_text(command, "--dialect", raw.dialect, "NAME",
             fmt::format("of G-code: {}; recognised when left out",
                         fmt::join(ref::kDialectNames, ", ")));
    add_text(command, "--tools", raw.tools, "FILE.tbl",
             "lengths of tools, LinuxCNC's table; that of --machine's .ini when left out");
    add_text(command, "--arc-tolerance", raw.radii_tolerance, "LENGTH",
             "by how much an arc's radii may differ; LinuxCNC's tolerance when left out")
        ->group(group::kRare);
}

void add_surroundings(CLI::App& command, RawOptions& raw, Options& options) {
    begin_group(command, group::kOutput);
    command.add_option("-o,--output", options.folder, kFileOut)->type_name("DIR");
    command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
    begin_group(command, group::kPlan);
    command.add_option("--machine", options.machine, "limits from LinuxCNC's .ini")
        ->type_name("FILE.ini");
    begin_group(command, group::kCore);
    add_text(command, "--unit", raw.unit, "LENGTH", "length unit: 2.5um, 1/65536in; default 1nm");
}

CLI::Option* add_input(CLI::App& command, RawOptions& raw, Options& options, std::string& feed,
                       const char* feeds, const std::string& feed_help) {
    begin_group(command, group::kInput);
    CLI::Option* file =
        command
            .add_option("FILE", options.file,
                        "G-code (.ngc .nc .gcode .tap ..) or points (.csv); - reads "
                        "G-code from standard input")
            ->type_name("");
    add_text(command, "--fit", raw.fit, "NAME",
             fmt::format("spline through points: {}; arcs: tangent arcs instead of splines, of "
                         "G-code too",
                         fmt::join(ref::kFitNames, ", ")));
    add_text(command, "--tolerance", raw.tolerance, "LENGTH",
             "of --fit arcs: how far they may be off the splines; default 1um")
        ->group(group::kRare);
    add_text(command, "--ends", raw.ends, "NAME",
             fmt::format("of --fit c2: {}", fmt::join(ref::kEndsNames, ", ")))
        ->group(group::kRare);
    add_text(command, "--parametrisation", raw.parametrisation, "NAME",
             fmt::format("of that spline: {}", fmt::join(ref::kParametrisationNames, ", ")))
        ->group(group::kRare);
    add_interpreter(command, raw);
    add_text(command, "--feed", feed, feeds, feed_help);
    add_surroundings(command, raw, options);
    return file;
}

void add_core(CLI::App& command, RawOptions& raw) {
    begin_group(command, group::kCore);
    add_text(command, "--core", raw.core, "FILE.json",
             "a core as choose writes it: parameters, unit, error, sample period, clock");
    add_text(command, "--build", raw.build, "BUILD", "parallel (default) or serial");
    add_text(command, "--device", raw.device, "NAME", device_names());
    add_text(command, "--error", raw.error, "LENGTH",
             fmt::format("worst error of a position on any axis, half a unit of rounding in it; "
                         "default {:g} units",
                         kDefaultBound + CoreParameters().rounding()));
}

void add_planning(CLI::App& command, RawOptions& raw) {
    begin_group(command, group::kPlan);
    add_text(command, "--effort", raw.effort, "NAME",
             fmt::format("of the feed: {}", fmt::join(ref::kEffortNames, ", ")))
        ->group(group::kRare);
    add_text(command, "--holds", raw.holds, "NAME",
             fmt::format("how a hold stops, by words for every place or slowly: {}",
                         fmt::join(ref::kHoldNames, ", ")));
    add_text(command, "--path", raw.path, "NAME",
             "program: within the tolerance that G64 allows; exact");
}

void add_override(CLI::App& command, RawOptions& raw) {
    begin_group(command, group::kPlan);
    command
        .add_option("--override", raw.override_percent,
                    "feed override, 1 to 200: up to 100 time is "
                    "scaled, above it feeds are planned higher, as far as limits allow")
        ->type_name("PERCENT")
        ->capture_default_str();
}

void add_timed_core(CLI::App& command, RawOptions& raw) {
    add_core(command, raw);
    add_text(command, "--board", raw.board, "NAME",
             "one of scripts/boards, or a file of such: its core, clock, sample period and queues");
    add_text(command, "--sample-period", raw.sample_period, "TIME",
             "time between samples; default 100us");
    add_text(command, "--samples-per-tick", raw.samples_per_tick, "N",
             "samples that share a tick of the feed profile, 2^n")
        ->group(group::kRare);
    add_text(command, "--segment-queue", raw.segment_queue, "WORDS",
             "SegmentQueueWords of the core: what is queued outlasts a stop, or moves are slowed");
    add_text(command, "--profile-queue", raw.profile_queue, "WORDS", "ProfileQueueWords of it");
    add_text(command, "--clock", raw.clock, "FREQUENCY",
             "the core's clock, which its steps are timed by; default 100MHz, or with --device its "
             "estimate there");
    add_list(command, "--set", raw.set, "NAME=VALUE",
             "a parameter of the core: " + ref::parameter_names());
    add_planning(command, raw);
}

void add_report(CLI::App& command, Options& options) {
    command
        .add_flag_callback(
            "--no-segments", [&options] { options.segments_file = false; },
            "segments.json is not written: it has a kilobyte of every segment")
        ->group(group::kRare);
}

void add_common(CLI::App& command, RawOptions& raw, Options& options) {
    add_input(command, raw, options, raw.feed, "SPEED", kAlongPoints)->required();
    add_timed_core(command, raw);
}

void add_run(CLI::App& command, RawOptions& raw, Options& options) {
    add_override(command, raw);
    begin_group(command, group::kBoard);
    command.add_option("--on", raw.on, fmt::format("board: {}", fmt::join(kBoardNames, ", ")))
        ->type_name("BOARD")
        ->capture_default_str();
    add_list(command, "--system", raw.system, "NAME=VALUE,..", "of --on systemc: " + system_names())
        ->delimiter(',')
        ->group(group::kRare);
    add_text(command, "--stall", raw.stall_seed, "SEED",
             "random stalls on every handshake of the RTL; the samples must not change")
        ->group(group::kRare);
    command.add_flag("--trace", options.trace,
                     "waves.fst of the RTL, system.vcd of pins and axes, and their .gtkw");
    command
        .add_option("--rows", raw.rows,
                    fmt::format("of samples.csv at most, default {}: of more samples every n-th; "
                                "all are checked",
                                options.most_rows))
        ->type_name("N")
        ->group(group::kRare);
    add_text(command, "--trace-clocks", raw.trace_clocks, "N", "clocks in the waveform")
        ->group(group::kRare);
}

}  // namespace curvecore::sysc
