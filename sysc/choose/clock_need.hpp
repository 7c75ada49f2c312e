// SPDX-License-Identifier: Apache-2.0
// Clocks that a core needs for a demand (hls/clocks.hpp).
#pragma once

#include "sysc/choose/demand.hpp"

namespace curvecore::sysc {

/// Least clock frequencies, Hz. `samples`: for the sample rate alone. `steps`: such that no sample
/// waits for an integration step or a segment.
///
///   parallel   samples: SampleInterval clocks each
///              steps:   a step while the path goes through the one before; a segment's words while
///                       the segment before is drawn
///   serial     samples: the clocks of a sample, or of a tick of time
///              steps:   within the sample periods that the samples ahead make up for, these
///                       samples and the pauses of as many steps and segments as there may be, at
///                       least one of each
struct ClockNeed {
    double samples = 0;
    double steps = 0;

    double least() const { return samples > steps ? samples : steps; }
};

ClockNeed clock_need(const CoreParameters& parameters, const Demand& demand,
                     double sample_period_s);

}  // namespace curvecore::sysc
