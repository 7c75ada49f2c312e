// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/wire_options.hpp"

#include <fmt/format.h>

#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

double duration_of(const std::string& option, const std::string& text) {
    const double time = duration(option, text);
    if (!(time >= 0 && time <= 10)) throw UsageError(option + " must be in [0, 10s]");
    return time;
}

void take_board(const RemoteBuild& build, Options& options) {
    options.for_steps = true;
    options.core = build.core;
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
