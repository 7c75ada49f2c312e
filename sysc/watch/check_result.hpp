// SPDX-License-Identifier: Apache-2.0
// Result of comparing a run's samples with kernel and exact curve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "sysc/watch/limit_meter.hpp"
#include "sysc/watch/tool_meter.hpp"

namespace curvecore::sysc {

struct AxisError {
    double max = 0;
    double sum_of_squares = 0;

    void add(double error) {
        max = std::max(max, std::abs(error));
        sum_of_squares += error * error;
    }
    double rms(std::uint64_t samples) const {
        return samples == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(samples));
    }
};

/// Worst figures of the segments of one kind, length units before the final rounding.
struct KindResult {
    std::uint64_t samples = 0;
    double error = 0;        // on any axis
    double bound = 0;        // derived; 0: none
    double of_bound = 0;     // error / bound of its segment
    double speed_error = 0;  // chord between samples - the exact curve's
};

/// Errors in length units.
struct CheckResult {
    std::uint64_t samples = 0;
    std::uint64_t differing_words = 0;  // RTL against kernel
    std::string first_difference;
    std::array<AxisError, ref::kMachineAxes> rounded;
    std::array<AxisError, ref::kMachineAxes> unrounded;
    std::map<std::string, KindResult> kinds;  // by Segment::kind_name()
    std::int64_t landing = 0;                 // worst output word - commanded word at a stop
    std::uint64_t stops = 0;                  // exact stops that a sample fell on
    double increment = 0;       // worst sample's increment - its share of the tick, quanta
    double speed_relative = 0;  // speed error of chords of kSpeedChord units or more, by the chord
    LimitLoads drawn;           // of the exact curve at the samples' path lengths
    LimitLoads rounded_limits;  // of the samples, with the rounding allowed for
    std::optional<ToolResult> tool;  // of a machine with modes
    double tool_off = 0;       // mm, the drawn joints' tool - its path, of a machine with joints
    double tool_of_bound = 0;  // the same, by what the joints' bounds allow
    double speed_of_allowed =
        0;  // speed error / (1e-6 chord + what the bounds allow, at least 0.1)

    /// Worst of all kinds.
    double worst(double KindResult::*figure) const {
        double most = 0;
        for (const auto& [name, kind] : kinds) most = std::max(most, kind.*figure);
        return most;
    }
};

}  // namespace curvecore::sysc
