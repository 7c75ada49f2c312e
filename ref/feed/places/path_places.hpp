// SPDX-License-Identifier: Apache-2.0
// The path's derivatives by path length at any place, which its limits depend on.
#pragma once

#include <boost/container/static_vector.hpp>
#include <memory>
#include <vector>

#include "ref/curve/arc_length.hpp"
#include "ref/curve/drawn/table_curve.hpp"
#include "ref/feed/places/place_limit.hpp"
#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

/// r', r'', r''' of all axes, mm and degrees per mm of path; and of the tool, where the axes are
/// joints.
struct PathPlace {
    AxisVector d1{};
    AxisVector d2{};
    AxisVector d3{};
    std::array<Vec3, 3> tool{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

/// Limits of the path and of every axis.
using PlaceLimits = boost::container::static_vector<PlaceLimit, 1 + kMachineAxes>;

/// The machine's limits there: of the path, and of the axes that it does not imply.
PlaceLimits place_limits(const PathPlace& at, const PathShape& shape, const Machine& machine);

/// The exact derivatives: lines and arcs in closed form, splines by Frenet's formulas at the
/// place's parameter, tables by their series. Places may come in any order; in the path's order
/// each spline's length is tabulated once.
class PathPlaces {
  public:
    PathPlaces(const Program& program, const Geometry& geometry, double unit_mm);

    /// Place s mm from the start of geometry.moves[planned], within it.
    PathPlace at(std::size_t planned, double s);

  private:
    PathPlace on_arc(const Move& move, const PathShape& shape, double s) const;
    PathPlace on_spline(const Move& move, double s);
    PathPlace on_table(const Move& move, double s);
    PathPlace on_joints(const JointPath& of, const PathShape& shape, double s) const;

    const Program& program_;
    const Geometry& geometry_;
    std::vector<double> begin_;  // mm, starts of planned moves in their move
    const Move* tabled_ = nullptr;
    std::unique_ptr<ArcLength> length_;
    std::unique_ptr<TableCurve> curve_;
};

}  // namespace curvecore::ref
