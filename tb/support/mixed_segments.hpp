// SPDX-License-Identifier: Apache-2.0
// Seeded segments of both kinds, for a core that draws lines, arcs and splines.
#pragma once

#include <random>

#include "tb/support/legal_segments.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {

template <class C>
class MixedSegments {
  public:
    using Words = hls::SegmentWords<C>;

    explicit MixedSegments(std::uint64_t seed)
        : random_(seed), arcs_(seed, kArcExponent), splines_(seed) {}

    Words next() { return random_() % 2 == 0 ? arcs_.next() : splines_.next(); }

    /// One of either kind in turn.
    Words whole(int k, int steps) {
        spline_now_ = !spline_now_;
        return spline_now_ ? splines_.whole(k, steps) : arcs_.whole(k, steps);
    }

  private:
    // A request that passes an arc's steps passes hundreds of a spline's.
    static constexpr int kArcExponent = 12;

    std::mt19937_64 random_;
    LegalSegments<C> arcs_;
    SplineSegments<C> splines_;
    bool spline_now_ = false;
};

}  // namespace curvecore::tb
