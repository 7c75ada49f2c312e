// SPDX-License-Identifier: Apache-2.0
// Clocks of the parallel cores, as the headers of the RTL state them.
#pragma once

#include <algorithm>

#include "tb/support/core_configuration.hpp"

namespace curvecore::tb {

enum Curves { kArcs = 1, kSplines = 2, kBothCurves = 3 };

constexpr int kDigits = (Config::kCoefBits + 1) / 2;

// Of an integration step: along an arc; along a spline, or a little fewer.
constexpr int kArcStepClocks = Config::kOrder * (kDigits + 3) + 7;
constexpr int kTop = Config::kAnchor ? Config::kOrder - 1 : Config::kOrder;
constexpr int kSplineStepClocks =
    94 + 9 * kTop * (kTop + 1) / 2 + 27 * kTop + 12 * Config::kOrder + 55 + kDigits;

constexpr int horner_clocks(int passes) {
    return passes * (CFG_SampleInterval == 1   ? 6
                     : CFG_SampleInterval == 2 ? 7
                                               : 9) +
           (CFG_SampleInterval == 1 ? 1 : 0);
}

constexpr int sampler_clocks(Curves curves) {
    if (CFG_Mode == 0) return horner_clocks(Config::kOrder);
    if (curves == kArcs) {
        return horner_clocks(Config::kOrder / 2) + (CFG_SampleInterval == 2 ? 19 : 18);
    }
    return horner_clocks(Config::kOrder) + horner_clocks(3) + (curves == kBothCurves ? 1 : 0);
}

/// From a request to its sample, and up to SampleInterval - 1 more.
constexpr int sample_latency(Curves curves) {
    return 12 + 3 * CFG_SampleInterval + sampler_clocks(curves);
}

/// That a step must hold for full rate.
constexpr int samples_of(int clocks) {
    return (clocks + CFG_SampleInterval - 1) / CFG_SampleInterval;
}

}  // namespace curvecore::tb
