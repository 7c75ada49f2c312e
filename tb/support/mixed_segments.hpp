// SPDX-License-Identifier: Apache-2.0
// Seeded segments of both kinds, each as likely as the other: lines and arcs, and splines.
#pragma once

#include <random>

#include "tb/support/legal_segments.hpp"
#include "tb/support/spline_segments.hpp"

namespace curvecore::tb {

template <class C>
class MixedSegments {
  public:
    explicit MixedSegments(std::uint64_t seed) : random_(seed), arcs_(seed), splines_(seed) {}

    hls::SegmentWords<C> next() { return random_() % 2 == 0 ? arcs_.next() : splines_.next(); }

  private:
    std::mt19937_64 random_;
    LegalSegments<C> arcs_;
    SplineSegments<C> splines_;
};

}  // namespace curvecore::tb
