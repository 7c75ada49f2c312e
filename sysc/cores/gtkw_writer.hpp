// SPDX-License-Identifier: Apache-2.0
// The file waves.gtkw: GTKWave opens waves.fst with signals in groups, in the order of the data
// flow.
#pragma once

#include <cstdint>
#include <string>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// The place where the picture opens: the clock that returned the first sample.
struct FirstSample {
    double clock_hz;
    std::uint64_t clock;
};

/// Arranges the signals of `fst_file`; `folder` is where both files will stand.
std::string gtkw(const CoreParameters& core, const std::string& fst_file, const std::string& folder,
                 const FirstSample& first);

/// Writes the head of a save file: `wave` and it stand in `folder`, `save` is its name, and it
/// opens on `span` ps of time from `start` on, with the marker at `marker`.
std::string gtkw_head(const std::string& folder, const std::string& wave, const std::string& save,
                      double start, double span, double marker);

}  // namespace curvecore::sysc
