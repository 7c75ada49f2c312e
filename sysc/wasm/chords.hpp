// SPDX-License-Identifier: Apache-2.0
// Chords for as many bits as a plan has, in the place of its curves, and how far they are off.
#pragma once

#include <cstddef>
#include <vector>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Bits of a chord: its end in three words of 32 bits, and its feed.
constexpr std::size_t kChordBits = 128;

struct Chords {
    std::size_t bits = 0;            // of the plan: segments and profile
    std::vector<ref::Vec3> corners;  // mm; the first is the path's start
    double off_mm = 0;               // of the curves from their chords, at most
    std::size_t worst = 0;           // chord that is off the most
    std::vector<ref::Vec3> beside;   // the path along that chord, mm

    std::size_t count() const { return corners.size() - 1; }
};

/// Every segment gets one chord. Curves get the others so that all of these are equally far off: as
/// many for a stretch as it has of the integral of sqrt(curvature) ds.
Chords chords_of_equal_traffic(const Job& job);

}  // namespace curvecore::sysc
