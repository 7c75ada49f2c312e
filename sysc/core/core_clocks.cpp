// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/core_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

using ref::CurveKind;

hls::TimedCore timed_core(const CoreParameters& parameters) {
    hls::TimedCore core;
    core.build = parameters.build;
    core.order = parameters.order;
    core.coef_bits = parameters.coef_bits;
    core.aux_axes = parameters.aux_axes;
    core.series = parameters.mode == 0;
    core.splines = parameters.splines != 0;
    core.sample_interval = parameters.sample_interval;
    core.anchor = parameters.anchor != 0;
    core.networks = parameters.networks != 0;
    return core;
}

namespace {

/// Clocks of a further word of a segment, which enters and is fetched.
constexpr int kFurtherClocks = hls::kEngineEntryClocks + 60;

/// Clocks of the engine along its table: those of its own programs, and what segments of arcs take
/// besides.
hls::Clocks table_clocks(const CoreParameters& parameters) {
    constexpr int kFetch = 1000;   // of a segment
    constexpr int kMeasure = 108;  // of a step, besides its curve
    const hls::TimedCore core = timed_core(parameters);
    const ref::CurveTable& table = *parameters.table;
    try {
        const assembler::Assembly programs = assembler::curve_program(table, parameters);
        const auto clocks = [&](const char* part) {
            return assembler::worst_case(programs, table.name + "_" + part, {"idle"});
        };
        const int sample = hls::engine_sample_clocks(core, clocks("sample"));
        return {sample, sample + kMeasure + clocks("step"),
                sample + kFetch + clocks("load") + hls::engine_entry_clocks(core)};
    } catch (const assembler::AssemblyError& error) {
        throw UsageError(
            fmt::format("the engine has no room for the table {}: {}; a lower Order "
                        "needs less",
                        table.name, error.what()));
    }
}

}  // namespace

hls::Clocks core_clocks(const CoreParameters& parameters, CurveKind kind) {
    const hls::TimedCore core = timed_core(parameters);
    const bool engine = parameters.build == Build::kEngine;
    hls::Clocks clocks = kind == CurveKind::kTable && parameters.table && engine
                             ? table_clocks(parameters)
                         : kind == CurveKind::kArc ? hls::arc_clocks(core)
                                                   : hls::spline_clocks(core);
    if (engine) clocks.segment += kFurtherClocks * parameters.further_words;
    return clocks;
}

hls::Clocks change_clocks(const CoreParameters& parameters, CurveKind kind) {
    hls::Clocks clocks = core_clocks(parameters, kind);
    if (hls::in_turn(parameters.build)) {
        // The first sample after a change may begin up to a rotation before the others' turn.
        const int early = parameters.build == Build::kSerial ? hls::kRotation : 0;
        clocks.step += early - clocks.sample;
        clocks.segment += early - clocks.sample;
    }
    return clocks;
}

double tick_share(const CoreParameters& parameters, int samples_per_tick) {
    if (parameters.build != Build::kEngine) return 0;
    const hls::TimedCore core = timed_core(parameters);
    const int window = 1 + hls::samples_ahead(core);  // samples
    const int ticks = (window + samples_per_tick - 1) / samples_per_tick;
    return double(hls::tick_clocks(core) * ticks) / window;
}

ref::CoreTime core_time(const CoreParameters& parameters, double clock_hz, int samples_per_tick) {
    ref::CoreTime time;
    time.samples_ahead = hls::samples_ahead(timed_core(parameters));
    time.ahead = !hls::in_turn(parameters.build);
    if (parameters.build == Build::kEngine) time.branch_steps = hls::kEngineBranchSteps;
    int sample = 0;  // clocks
    for (const CurveKind kind : ref::kCurveKinds) {
        const hls::Clocks clocks = change_clocks(parameters, kind);
        time.curve[kind] = {clocks.step / clock_hz, clocks.segment / clock_hz};
        if (draws(parameters, kind)) sample = std::max(sample, clocks.sample);
    }
    if (!time.ahead) time.sample = (sample + tick_share(parameters, samples_per_tick)) / clock_hz;
    return time;
}

double least_period_clocks(const CoreParameters& parameters, bool splines, int samples_per_tick) {
    double least = hls::tick_clocks(timed_core(parameters)) / double(samples_per_tick);
    for (const CurveKind kind : ref::kCurveKinds) {
        if (kind == CurveKind::kSpline && !splines) continue;
        if (kind == CurveKind::kTable && !parameters.table) continue;
        const hls::Clocks clocks = core_clocks(parameters, kind);
        double period = clocks.sample + tick_share(parameters, samples_per_tick);
        if (hls::in_turn(parameters.build)) {
            const hls::Clocks change = change_clocks(parameters, kind);
            period += std::max(change.step, change.segment) /
                      (1.0 + hls::samples_ahead(timed_core(parameters)));
        }
        least = std::max(least, period);
    }
    return least;
}

void check_period(const CoreParameters& parameters, bool splines, double period_s, double clock_hz,
                  int samples_per_tick) {
    const double least = least_period_clocks(parameters, splines, samples_per_tick);
    if (period_s * clock_hz >= least * (1 - 1e-9)) return;
    throw UsageError(fmt::format(
        "a sample period has {:.4g} clocks, and this {} core needs {:.4g}: --sample-period must be "
        "at least {:.4g}us, or --clock {:.4g}MHz",
        period_s * clock_hz, build_name(parameters.build), least, least / clock_hz * 1e6,
        least / period_s * 1e-6));
}

}  // namespace curvecore::sysc
