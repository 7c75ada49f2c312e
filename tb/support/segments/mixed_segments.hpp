// SPDX-License-Identifier: Apache-2.0
// Seeded segments of both kinds, for a core that draws lines, arcs and splines.
#pragma once

#include <random>

#include "tb/support/segments/legal_segments.hpp"
#include "tb/support/segments/spline_segments.hpp"

namespace curvecore::tb {

class MixedSegments {
  public:
    /// Creates a generator whose arcs have steps of at most 2^longest units: a request that passes
    /// an arc's steps may pass hundreds of a spline's.
    MixedSegments(const CoreParameters& core, std::uint64_t seed, int longest = 12)
        : random_(seed), arcs_(core, seed, longest), splines_(core, seed) {}

    RunSegment next() { return random_() % 2 == 0 ? arcs_.next() : splines_.next(); }

    /// A segment of full steps, of either kind in turn.
    RunSegment whole(int k, int steps) {
        spline_now_ = !spline_now_;
        return spline_now_ ? splines_.whole(k, steps) : arcs_.whole(k, steps);
    }

  private:
    std::mt19937_64 random_;
    LegalSegments arcs_;
    SplineSegments splines_;
    bool spline_now_ = false;
};

}  // namespace curvecore::tb
