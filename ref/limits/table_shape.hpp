// SPDX-License-Identifier: Apache-2.0
// Stretches of a table's curve with bounds of its derivatives, for the speed along it.
#pragma once

#include <vector>

#include "ref/curve/drawn/table_curve.hpp"
#include "ref/limits/path_shape.hpp"

namespace curvecore::ref {

/// A stretch between two places, mm from the move's start, and bounds that hold all along it: what
/// is found at places, and by how much the next derivative may raise it between them; that of order
/// 4 by the sum of its series.
struct TableStretch {
    double from = 0;
    double to = 0;
    PathShape shape;
};

/// Returns stretches that lose no more than 40 % of the speed that machine and feed allow at any of
/// their places, in order. `curve` is that of the move (mm).
std::vector<TableStretch> table_stretches(const Move& move, const TableCurve& curve,
                                          const Machine& machine, double from, double to);

}  // namespace curvecore::ref
