// SPDX-License-Identifier: Apache-2.0
// The tool's place along a move as a series in its path, and that of the joints.
#pragma once

#include <boost/math/differentiation/autodiff.hpp>

#include "ref/curve/joint_path.hpp"
#include "ref/machine/kinematics.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// A number and its derivatives by the path, to the tool's orders. Boost differentiates: Taylor
/// arithmetic.
using PathSeries = boost::math::differentiation::autodiff_fvar<double, kToolOrders>;

/// The tool at the path length s, 0 .. length, and from there on. @param length that of the move
ToolPose<PathSeries> tool_series(const Move& move, double length, double s);

/// The tool at s, of any move but those of joints.
ToolPose<double> tool_at(const Move& move, double length, double s);

/// Coefficients of the series of three numbers.
VectorSeries<kToolOrders> coefficients(const std::array<PathSeries, 3>& of);

}  // namespace curvecore::ref
