// SPDX-License-Identifier: Apache-2.0
// Ends of a motion's phases on the grid of ticks, where its pieces join.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/feed/ramps/phase.hpp"

namespace curvecore::ref {

/// The ends of phases in time, s, and in ticks of a motion that is stretched to whole ones. End 0
/// is the motion's start, and end i + 1 that of phase i.
class PhaseEnds {
  public:
    /// @param tick s, of the core
    PhaseEnds(const std::vector<Phase>& phases, double tick);

    std::uint64_t ticks() const { return ticks_; }
    /// Time of the motion in a tick, s: the core's tick or less.
    long double tick() const { return tick_; }
    const std::vector<long double>& times() const { return times_; }
    std::uint64_t nearest(std::size_t end) const;

    /// Returns the motion with these ends at the other tick beside them than the nearest, at its
    /// place and speed there. An end that another is too near to stays.
    std::vector<Phase> moved(const std::vector<std::size_t>& ends) const;

  private:
    const std::vector<Phase>& phases_;
    std::vector<long double> times_;
    std::uint64_t ticks_;
    long double tick_;
};

}  // namespace curvecore::ref
