// SPDX-License-Identifier: Apache-2.0
// Three joints of a machine along a piece of its tool's path.
#pragma once

#include "ref/curve/vector_series.hpp"

namespace curvecore::ref {

/// Orders of the series that a core draws (ref/curves/series.net), and of the tool's own.
constexpr int kJointOrders = 6;
constexpr int kToolOrders = 8;

/// | field   | unit        | remark                                                            |
/// |---------|-------------|-------------------------------------------------------------------|
/// | stretch | 1           | of the path that the core draws: so many times as long as the      |
/// |         |             | tool's, that no joint goes farther than it                         |
/// | length  | mm          | of that path                                                      |
/// | joints  | mm, degrees | by it; error: below that of the words                              |
/// | tool    | mm          | by it                                                             |
struct JointPath {
    double stretch = 1;
    double length = 0;
    VectorSeries<kJointOrders> joints;
    VectorSeries<kToolOrders> tool;

    /// The part between two places of the path.
    JointPath part(double from, double to) const {
        return {stretch, to - from, joints.shifted(from), tool.shifted(from)};
    }
};

}  // namespace curvecore::ref
