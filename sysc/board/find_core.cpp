// SPDX-License-Identifier: Apache-2.0
#include "tb/program/rtl_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tb/command/usage_error.hpp"

namespace curvecore::tb {

namespace {

/// What --set leaves open, the simpler first.
std::pair<int, int> open_parameters(const CompiledCore& core) {
    return {core.parameters.splines, core.parameters.aux_axes};
}

bool serves(const CompiledCore& core, const Options& options) {
    CoreParameters wanted = options.core;
    if (!options.splines_set) wanted.splines = std::max(wanted.splines, core.parameters.splines);
    if (!options.aux_axes_set) {
        wanted.aux_axes = std::max(wanted.aux_axes, core.parameters.aux_axes);
    }
    return wanted == core.parameters;
}

}  // namespace

const CompiledCore& find_core(const Options& options) {
    const CoreParameters& wanted = options.core;
    const CompiledCore* best = nullptr;
    for (const CompiledCore& core : compiled_cores()) {
        if (!serves(core, options)) continue;
        if (best == nullptr || open_parameters(core) < open_parameters(*best)) best = &core;
    }
    if (best != nullptr) return *best;
    std::string list;
    for (const CompiledCore& core : compiled_cores()) {
        list +=
            fmt::format("\n  {:8}  {}", build_name(core.parameters.build), core.parameters.text());
    }
    throw UsageError(
        fmt::format("no compiled core {} {}; tb/program/compiled_cores.cmake makes these:{}",
                    build_name(wanted.build), wanted.text(), list));
}

}  // namespace curvecore::tb
