// SPDX-License-Identifier: Apache-2.0
// Clocks that a core needs for a demand, as the headers of the RTL state them.
#pragma once

#include "tb/choose/demand.hpp"

namespace curvecore::tb {

/// Least clock frequencies, Hz. `samples`: for the sample rate alone. `steps`: that no sample waits
/// for an integration step or a segment.
///
///   parallel   samples: SampleInterval clocks each
///              steps:   a step's latency while the path goes through the one before; 20 + 3
///              AuxAxes
///                       clocks for a segment's words
///   serial     samples: as rtl/curve_interpolator_serial.sv states them, one multiplier
///              steps:   within every sample period the sample, and the pauses of as many steps and
///                       segments as it may see, at least one of each; and the planner's own limit
struct ClockNeed {
    double samples = 0;
    double steps = 0;

    double least() const { return samples > steps ? samples : steps; }
};

ClockNeed clock_need(const CoreParameters& parameters, const Demand& demand,
                     double sample_period_s);

}  // namespace curvecore::tb
