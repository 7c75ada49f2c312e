// SPDX-License-Identifier: Apache-2.0
#include "tb/program/rtl_run.hpp"

#include <fmt/format.h>

#include "tb/program/usage_error.hpp"

namespace curvecore::tb {

const CompiledCore& find_core(const CoreParameters& wanted, bool exact_aux_axes) {
    const CompiledCore* best = nullptr;
    for (const CompiledCore& core : compiled_cores()) {
        CoreParameters with_its_axes = wanted;
        with_its_axes.aux_axes = core.parameters.aux_axes;
        const bool fits = exact_aux_axes ? core.parameters.aux_axes == wanted.aux_axes
                                         : core.parameters.aux_axes >= wanted.aux_axes;
        if (with_its_axes == core.parameters && fits &&
            (best == nullptr || core.parameters.aux_axes < best->parameters.aux_axes)) {
            best = &core;
        }
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
