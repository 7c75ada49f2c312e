// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/wire_options.hpp"

#include <fmt/format.h>

#include <sstream>

#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

double duration_of(const std::string& option, const std::string& text) {
    const double time = duration(option, text);
    if (!(time >= 0 && time <= 10)) throw UsageError(option + " must be in [0, 10s]");
    return time;
}

void plan_for(const RemoteBuild& build, Options& options) {
    options.for_steps = true;
    options.core = build.core;
    options.splines_set = options.aux_axes_set = true;
    options.sample_period_s = build.sample_period_s;
    options.clock_hz = build.clock_hz;
    options.segment_queue_words = build.segment_queue_words;
    options.profile_queue_words = build.profile_queue_words;
}

void plan_for(const std::string& link, Options& options) {
    try {
        plan_for(ask_build(*open_link(link)), options);
    } catch (const BoardLost& lost) {
        throw UsageError(link + ": " + lost.what());
    }
}

Drives drives_of(const RawWireOptions& raw, int axes) {
    Drives drives;
    std::istringstream list(raw.steps_per_mm);
    for (std::string text; std::getline(list, text, ',');) {
        const double steps = quantity("--steps-per-mm", text, {{"", 0}});
        if (!(steps > 0)) throw UsageError("--steps-per-mm must be above 0");
        drives.steps_per_mm.push_back(steps);
    }
    if (drives.steps_per_mm.size() == 1) drives.steps_per_mm.resize(axes, drives.steps_per_mm[0]);
    if (drives.steps_per_mm.size() != static_cast<std::size_t>(axes)) {
        throw UsageError(fmt::format("--steps-per-mm has {} values, and the board {} axes",
                                     drives.steps_per_mm.size(), axes));
    }
    drives.steplen_s = duration_of("--steplen", raw.steplen);
    drives.stepspace_s = duration_of("--stepspace", raw.stepspace);
    drives.dirsetup_s = duration_of("--dirsetup", raw.dirsetup);
    drives.dirhold_s = duration_of("--dirhold", raw.dirhold);
    return drives;
}

}  // namespace curvecore::sysc
