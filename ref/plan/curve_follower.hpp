// SPDX-License-Identifier: Apache-2.0
// The exact curve of a plan, sample by sample in the order of the path.
#pragma once

#include <memory>

#include "ref/plan/segment_curve.hpp"

namespace curvecore::ref {

/// Keeps the exact curve while the segment stays the same.
class CurveFollower {
  public:
    /// Returns the curve of the segment, which must outlive the calls that follow.
    const PathCurve& on(const Segment& segment) {
        if (&segment != segment_) {
            segment_ = &segment;
            curve_ = exact_curve(segment);
        }
        return *curve_;
    }

  private:
    const Segment* segment_ = nullptr;
    std::shared_ptr<const PathCurve> curve_;  // copies of the follower share it
};

}  // namespace curvecore::ref
