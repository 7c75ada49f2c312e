// SPDX-License-Identifier: Apache-2.0
// A sweep: many configurations against one program, on all processors.
#pragma once

#include "sysc/compare/comparison.hpp"

namespace curvecore::sysc {

/// A scheme that steps once a tick, in a configuration's order and words.
struct TickedSetting {
    CoreParameters setting;
    TickScheme ticks;
};

struct SweepOptions {
    double unit_mm = 1e-6;
    double limit = 0.1;      // units: derived bound that the plans keep
    int times_segments = 4;  // multiple of the segments that the widest words need
    std::int64_t samples = 100000;
    const Device* device = nullptr;
    std::vector<TickedSetting> ticked;
    bool by_move = false;
    bool quiet = false;  // no bar
};

/// The finished rows, in the order of the settings, then of `ticked`.
struct SweepResult {
    std::vector<Row> rows;
    bool interrupted = false;
    std::size_t reference_segments = 0;
    std::size_t most_segments = 0;
    std::int64_t samples = 0;
    double seconds = 0;
};

/// Compares all settings. Neighbours in the list that differ only in what no plan depends on share
/// a plan. An interruption (InterruptGuard) ends the sweep with the rows that are finished.
/// @throws ref::InputError, as Segmenter does
SweepResult sweep(const ref::Program& program, const ref::Machine& machine,
                  const std::vector<CoreParameters>& settings, const SweepOptions& options);

}  // namespace curvecore::sysc
