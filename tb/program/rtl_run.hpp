// SPDX-License-Identifier: Apache-2.0
// A run through one compiled core, and the list of those that were compiled.
#pragma once

#include <functional>
#include <vector>

#include "tb/program/check_result.hpp"
#include "tb/program/pictures.hpp"
#include "tb/program/samples_writer.hpp"

namespace curvecore::tb {

struct RtlRun {
    const Job& job;
    std::uint64_t samples;
    SamplesWriter& writer;
    Pictures& pictures;
    std::string waveform;  // empty: none
    std::function<void(std::uint64_t samples)> progress;
};

struct RtlResult {
    CheckResult check;
    std::uint64_t clocks = 0;
    double seconds = 0;  // of simulation
    bool underrun = false;
    std::uint64_t empty_segments = 0;
};

struct CompiledCore {
    CoreParameters parameters;
    RtlResult (*run)(const RtlRun& setup);
};

/// tb/program/compiled_cores.cmake says which.
const std::vector<CompiledCore>& compiled_cores();

/// The core for options.core. One that can do more will do for what --set did not ask for: more
/// auxiliary axes, splines.
/// @throws UsageError that lists what there is
const CompiledCore& find_core(const Options& options);

}  // namespace curvecore::tb
