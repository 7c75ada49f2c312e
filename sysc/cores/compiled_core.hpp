// SPDX-License-Identifier: Apache-2.0
// The Verilated cores inside the program: sysc/cores/compiled_cores.cmake.
#pragma once

#include "sysc/cores/rtl_setup.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct CompiledCore {
    CoreParameters parameters;
    MakeBoard* make;
};

const std::vector<CompiledCore>& compiled_cores();

/// Finds the core for options.core; null: none. A core that can do more is taken where --set leaves
/// it open: more auxiliary axes, splines.
const CompiledCore* find_core(const Options& options);

}  // namespace curvecore::sysc
