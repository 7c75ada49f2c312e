// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "sysc/cores/compiled_core.hpp"

namespace curvecore::sysc {
namespace {

bool serves(const CompiledCore& core, const Options& options) {
    CoreParameters wanted = options.core;
    wanted.multiplier_form = core.parameters.multiplier_form;  // its products are the same
    if (!options.splines_set) wanted.splines = std::max(wanted.splines, core.parameters.splines);
    return wanted == core.parameters;
}

}  // namespace

const CompiledCore* find_core(const Options& options) {
    // The simpler core comes first.
    const auto& cores = compiled_cores();
    const auto found = std::find_if(cores.begin(), cores.end(), [&](const CompiledCore& core) {
        return serves(core, options);
    });
    return found == cores.end() ? nullptr : &*found;
}

}  // namespace curvecore::sysc
