// SPDX-License-Identifier: Apache-2.0
// A piece of any curve that a table describes (ref/curves/curve_table.hpp), as a core draws it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>

#include "ref/curve/drawn/path_curve.hpp"
#include "ref/curves/curve_table.hpp"

namespace curvecore::ref {

/// The rows of a table's bus by the names of hls/words.hpp, where its path is a unit long: a row of
/// power p (ref/curves/row_powers.hpp) is in 1 / length^p. In words for steps of h it is h^p times
/// that. The table outlives its pieces.
struct TablePiece {
    const CurveTable* table = nullptr;
    double theta = 0;
    Vec3 tangent = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    Vec3 advance = Vec3::Zero();
    std::array<double, kMostFurther> further{};

    const char* name() const { return table->name.c_str(); }
    std::unique_ptr<PathCurve> path(const Vec3& start, double length) const;

    /// Number of a place of the bus; of a row of three axes, that of an axis.
    double& at(const std::string& place, int axis);
    double at(const std::string& place, int axis) const;
    /// The rows in steps of h.
    std::map<std::string, std::array<double, 3>> rows(double h) const;
    /// The same curve where lengths are `factor` times as many.
    TablePiece rescaled(double factor) const;
};

}  // namespace curvecore::ref
