// SPDX-License-Identifier: Apache-2.0
// hls::SegmentWords and hls::to_words for widths that are known at run time only.
#pragma once

#include "ref/curve/segment.hpp"
#include "sysc/widths/run_time_words.hpp"

namespace curvecore::sysc {

/// Fields as hls/words.hpp has them; for a spline theta is phi, tangent normal advance are a b c.
struct RunSegment {
    bool spline = false;
    std::int64_t length = 0;
    RunWord theta = 0;
    int step_exponent = 0;
    int lambda = 0;
    RunWord start[kMostAxes] = {};
    RunWord end[kMostAxes] = {};
    RunWord tangent[3] = {};
    RunWord normal[3] = {};
    RunWord advance[kMostAxes] = {};
};

/// @throws std::range_error when a word cannot hold its value, as hls::quantise does
RunSegment to_run_words(const ref::Segment& segment, const CoreParameters& format, int axes);

}  // namespace curvecore::sysc
