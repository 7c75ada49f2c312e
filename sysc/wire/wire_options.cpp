// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/wire_options.hpp"

#include <fmt/format.h>

#include "hls/registers/board_facts.h"
#include "ref/curve/joint_path.hpp"
#include "ref/curves/curve_table.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/curves/named_table.hpp"

namespace curvecore::sysc {

double duration_of(const std::string& option, const std::string& text) {
    const double time = duration(option, text);
    if (!(time >= 0 && time <= 10)) throw UsageError(option + " must be in [0, 10s]");
    return time;
}

namespace {

/// Returns the table that the board draws and the program names, if any; a shipped one need not be
/// named. @throws UsageError: they are not the same
std::shared_ptr<const ref::CurveTable> table_of(const RemoteBuild& build, const Options& options) {
    std::shared_ptr<const ref::CurveTable> table = options.core.table;
    if (!table && build.table == 0) return table;
    if (!table) table = numbered_table(build.table);
    if (!table) {
        throw UsageError(
            fmt::format("the board draws a table of its own, number {}: name its file by --curve",
                        build.table));
    }
    const std::uint32_t number = curvecore_table_number(table->text.c_str());
    if (number == build.table) {
        if (table->name != "series" || build.core.order <= ref::kJointOrders) return table;
        throw UsageError(fmt::format("joints are drawn with Order 2 .. {}, and the board has {}",
                                     ref::kJointOrders, build.core.order));
    }
    throw UsageError(fmt::format(
        "the board draws {}, and this program needs the table {}, number {}: begin the board with "
        "--curve {}, or make it with Table={}",
        build.table == 0 ? "no further table" : fmt::format("another table, {}", build.table),
        table->name, number, table->name, number));
}

}  // namespace

void take_board(const RemoteBuild& build, Options& options) {
    std::shared_ptr<const ref::CurveTable> table = table_of(build, options);
    options.for_steps = true;
    options.core = build.core;
    ref::add_table(std::move(table), options.core);
    options.splines_set = options.aux_axes_set = true;
    options.sample_period_s = build.sample_period_s;
    options.clock_hz = build.clock_hz;
    options.segment_queue_words = build.segment_queue_words;
    options.profile_queue_words = build.profile_queue_words;
    options.outputs = build.outputs;
    options.gcode.obeyed.outputs = build.outputs > 0;
    options.gcode.obeyed.analog = options.rules.full_q > 0;
}

void take_board(const std::string& link, Options& options) {
    try {
        take_board(ask_build(*open_link(link)), options);
    } catch (const BoardLost& lost) {
        throw UsageError(link + ": " + lost.what());
    }
}

void shape(const ref::Machine& machine, const RemoteBuild& build, Drives& drives) {
    if (machine.shaper == ref::ShaperKind::kNone) return;
    if (build.shaper_places == 0) {
        throw UsageError(machine.name + ": SHAPER needs a board with the parameter Shaper");
    }
    const int most = build.shaper_places / 2 - 1;
    drives.shaper = ref::shaper_taps(machine, build.sample_period_s, most);
    drives.tool_delay = ref::tool_delay(machine, drives.shaper, build.sample_period_s);
}

Drives drives_of(const WireOptions& options, int axes) {
    Drives drives = options.drives;
    std::vector<double>& scales = drives.steps_per_mm;
    if (scales.size() == 1) scales.resize(axes, scales[0]);
    if (scales.size() != static_cast<std::size_t>(axes)) {
        throw UsageError(fmt::format("--steps-per-mm has {} values, and the board {} axes",
                                     scales.size(), axes));
    }
    return drives;
}

}  // namespace curvecore::sysc
