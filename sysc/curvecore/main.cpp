// SPDX-License-Identifier: Apache-2.0
// curvecore run | plan | words | compare | choose: parts through the cores, from the command line.
//
// Exit status: 0 done and every check held; 1 a check failed; 2 the input or the command line is
// wrong, and nothing was written; 3 choose: no configuration keeps the wish; 130 interrupted,
// nothing written (compare: what was finished).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "ref/program/input_error.hpp"
#include "tb/command/interrupt.hpp"
#include "tb/command/usage_error.hpp"
#include "tb/program/choose_command.hpp"
#include "tb/program/commands.hpp"
#include "tb/program/compare_command.hpp"

namespace curvecore::tb {
namespace {

/// FILE, and what is read with it.
CLI::Option* add_input(CLI::App& command, RawOptions& raw, Options& options) {
    CLI::Option* file =
        command.add_option("FILE", options.file, "G-code (.ngc .nc .gcode .tap) or points (.csv)")
            ->type_name("");
    command.add_option("-o,--output", options.folder, "folder for the results")
        ->required()
        ->type_name("DIR");
    command
        .add_option("--fit", raw.fit,
                    fmt::format("spline through points: {}", fmt::join(ref::kFitNames, ", ")))
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option(
            "--parameter", raw.parameter,
            fmt::format("the spline's parameter: {}", fmt::join(ref::kParameterNames, ", ")))
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--feed", raw.feed, "feed along points, mm/min")
        ->type_name("FEED")
        ->capture_default_str();
    command.add_option("--unit", raw.unit, "length unit: 1nm, 10nm, 0.1um or 1um")
        ->type_name("LENGTH")
        ->capture_default_str();
    command.add_option("--machine", options.machine, "limits from LinuxCNC's .ini")
        ->type_name("FILE.ini");
    command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
    return file;
}

void add_common(CLI::App& command, RawOptions& raw, Options& options) {
    add_input(command, raw, options)->required();
    command.add_option("--sample-period", raw.sample_period, "time between samples")
        ->type_name("TIME")
        ->capture_default_str();
    command
        .add_option("--samples-per-tick", raw.samples_per_tick,
                    "samples that share a tick of the feed profile, 2^n")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--clock", raw.clock, "the core's clock, for the planner's latency limit")
        ->type_name("FREQUENCY")
        ->capture_default_str();
    command.add_option("--build", raw.build, "parallel or serial")
        ->type_name("BUILD")
        ->capture_default_str();
    command.add_option("--limit", raw.limit, "derived bound of the error that every segment keeps")
        ->type_name("UNITS")
        ->capture_default_str();
    command
        .add_option("--set", raw.set,
                    fmt::format("a parameter of the core: {}", fmt::join(parameter_names(), ", ")))
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
}

void add_run(CLI::App& command, RawOptions& raw, Options& options) {
    command
        .add_option("--stall", raw.stall_seed,
                    "random stalls on every handshake; the samples must not change")
        ->type_name("SEED");
    command.add_option("--override", raw.override_percent, "feed override, 1 to 100")
        ->type_name("PERCENT")
        ->capture_default_str();
    command.add_flag("--trace", options.trace, "write waves.fst, and waves.gtkw that arranges it");
    command.add_option("--trace-clocks", raw.trace_clocks, "clocks in the waveform")
        ->type_name("N")
        ->capture_default_str();
}

void add_compare(CLI::App& command, RawOptions& raw, RawCompareOptions& compare,
                 CompareOptions& options) {
    add_input(command, raw, options.common);
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const std::string& help) {
        command.add_option(name, text, help)->type_name(type)->capture_default_str();
    };
    add("--curves", compare.curves, "NAME",
        fmt::format("without FILE, built-in curves: {}", fmt::join(kCurveSets, ", ")));
    add("--order", compare.order, "LIST", "4,6 or 4:8 or 4:8:2; the same for the next six");
    add("--coef-bits", compare.coef_bits, "LIST",
        "width of coefficients; weights and tau have a bit of fraction less");
    add("--guard-bits", compare.guard_bits, "LIST", "fraction bits of a position inside");
    add("--mode", compare.mode, "LIST", "sampler: 0 series, 1 polynomial");
    add("--anchor", compare.anchor, "LIST", "splines: 1 anchored, 0 propagated as in the paper");
    add("--turn-bits", compare.turn_bits, "LIST",
        "of arcs with --mode 0: steps of at most 2^-N rad, and a width for each order; 0: all "
        "alike");
    add("--parameter-guard", compare.parameter_guard, "LIST",
        "of splines: fraction bits in which the parameter (u) adds up, below those of tau");
    add("--limit", compare.limit, "UNITS", "derived bound that plans keep if they can");
    add("--segments", compare.segments, "TIMES",
        "segments that a plan may have, in times of those with the widest words");
    add("--samples", compare.samples, "N", "places at which each configuration is compared");
    add("--device", compare.device, "NAME", "whose LUT4 and MHz are estimated");
    add("--build", compare.build, "NAME", "serial or parallel, for the estimate");
    add("--interval", compare.interval, "CLOCKS",
        "between samples of the parallel build, for the estimate: 1, 2, 4 or 8");
}

void add_choose(CLI::App& command, RawWish& raw, ChooseOptions& options) {
    const auto add = [&command](const char* name, std::string& text, const char* type,
                                const char* help) {
        return command.add_option(name, text, help)->type_name(type)->capture_default_str();
    };
    add("--error", raw.error, "LENGTH",
        "worst error of a position on any axis, as the core gives it")
        ->required();
    add("--feed", raw.feed, "SPEED", "along the path, where acceleration lets it: 10m/min, 100mm/s")
        ->required();
    add("--device", raw.device, "NAME",
        "up5k, hx8k, ecp5-25, ecp5-45, ecp5-85, gw2a-18 or lifcl-40")
        ->required();
    add("--radius", raw.radius, "LENGTH",
        "largest radius of arcs and helices; lines come with them");
    add("--least-radius", raw.least_radius, "LENGTH", "smallest radius; 10um when left out");
    add("--length", raw.length, "LENGTH", "longest spline");
    add("--travel", raw.travel, "LENGTH",
        "positions go so far to both sides; the largest radius or length when left out");
    add("--unit", raw.unit, "LENGTH",
        "length unit: 1nm, 10nm, 0.1um or 1um; the best one when left out");
    add("--sample-rate", raw.sample_rate, "FREQUENCY", "samples a second");
    add("--clock", raw.clock, "FREQUENCY", "that the core must run at; any when left out");
    add("--host-words", raw.host_words, "N", "words of 48 bits a second that the host can send");
    add("--build", raw.build, "BUILD", "parallel or serial; either when left out");
    command.add_option("--machine", options.machine, "acceleration and jerk from LinuxCNC's .ini")
        ->type_name("FILE.ini");
    command.add_option("-o,--output", options.folder, "folder for choose.json")->type_name("DIR");
    command.add_flag("--confirm", options.confirm,
                     "place and route the answer with scripts/synth.sh: minutes");
    command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
    command.footer(
        "Exit status: 0 there is one; 1 --confirm failed or is too slow; 2 the command line is "
        "wrong; "
        "3 no core keeps the wish, and the answer says what to give up.");
}

int dispatch(int argc, char** argv) {
    CLI::App app{"Lines, arcs, helices and splines through FPGA interpolator cores", "curvecore"};
    app.set_version_flag("--version", "curvecore " CURVECORE_VERSION);
    app.require_subcommand(1);
    RawOptions raw;
    Options options;
    CLI::App* run = app.add_subcommand(
        "run", "plan FILE and run it through the Verilated RTL; compare every sample");
    CLI::App* plan = app.add_subcommand(
        "plan", "the same without the RTL: segments, feed profile, predicted error and time");
    CLI::App* words =
        app.add_subcommand("words", "segment and profile words as memory files for $readmemh");
    for (CLI::App* command : {run, plan, words}) add_common(*command, raw, options);
    add_run(*run, raw, options);
    CLI::App* compare = app.add_subcommand(
        "compare", "orders, widths and samplers through the bit-true kernel, side by side");
    RawCompareOptions raw_compare;
    CompareOptions compare_options;
    add_compare(*compare, raw, raw_compare, compare_options);
    CLI::App* choose = app.add_subcommand(
        "choose", "the smallest core that is proven to keep an error at a feed in a device");
    RawWish raw_wish;
    ChooseOptions choose_options;
    add_choose(*choose, raw_wish, choose_options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (*compare) {
        interpret(raw, compare_options.common);
        interpret(raw_compare, compare_options);
        return compare_command(compare_options);
    }
    if (*choose) {
        interpret(raw_wish, choose_options);
        return choose_command(choose_options);
    }
    interpret(raw, options);
    if (*run) return run_command(options);
    return *plan ? plan_command(options) : words_command(options);
}

}  // namespace
}  // namespace curvecore::tb

int main(int argc, char** argv) {
    try {
        return curvecore::tb::dispatch(argc, argv);
    } catch (const curvecore::ref::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    } catch (const curvecore::tb::UsageError& error) {
        fmt::print(stderr, "curvecore: error: {}\n", error.what());
        return 2;
    } catch (const curvecore::tb::Interrupted&) {
        return 130;
    } catch (const std::exception& error) {
        fmt::print(stderr, "curvecore: internal error: {}\n", error.what());
        return 1;
    }
}
