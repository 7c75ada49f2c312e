// SPDX-License-Identifier: Apache-2.0
// A smooth curve within a tube about the programmed path.
//
// r(s) is a cubic B-spline over the programmed path's own length s. Between knots and the path's
// joints the deviation e(s) = r(s) - q(s) is one cubic, so it is nowhere longer than the longest of
// its four Bezier points: these are the rows below. The parameter pairs both paths from end to end,
// so each keeps the distance from the other (Frechet), also where they cross themselves.
//
// The solution is the curve with |e| < tolerance and the least jerk at the speeds v,
//
//     sum over spans of (v / h)^5 |d3|^2,   d3 = h^3 r''' / 6     (integral of (r''' v^3)^2 dt)
//
// by a logarithmic barrier and Newton's method: no iterate leaves the tube.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ref/path/tube/cubic_spline.hpp"
#include "ref/path/tube/programmed_path.hpp"

namespace curvecore::ref {

/// Condition at an end: the position alone, or r' and r'' by s as well.
struct TubeEnd {
    bool at_rest = false;  // the position alone
    Vec3 position = Vec3::Zero();
    Vec3 slope = Vec3::Zero();
    Vec3 bend = Vec3::Zero();

    std::size_t points() const { return at_rest ? 1 : 3; }
};

class TubeSpline {
  public:
    /// Makes a spline of knots that ascend within the path, with six spans at least.
    TubeSpline(const ProgrammedPath& path, double tolerance, const std::vector<double>& knots,
               const TubeEnd& start, const TubeEnd& end);

    /// Fits by least squares, with weights that grow outside the tube. Returns true if the tube is
    /// kept.
    bool fit();
    /// Stages of three, in which the barrier is lowered from 1 / 25 of its first value.
    struct Stages {
        std::size_t first, end;
    };
    /// Minimises the jerk at these speeds, one for each span; after fit() returned true.
    void smooth(const std::vector<double>& speeds, const Stages& stages);

    const CubicSpline& spline() const { return spline_; }
    /// Bound of |e| over a span, mm.
    double deviation(std::size_t span) const;

  private:
    struct Row {
        std::size_t span;
        std::array<double, 4> weight;
        Vec3 target;
        bool free;  // not of given points alone
    };

    void add_rows(const ProgrammedPath& path);
    Vec3 error(const Row& row) const;
    bool is_free(std::size_t point) const { return point >= first_ && point < last_; }
    double worst() const;
    void least_squares(const std::vector<double>& weights);
    Vec3 third_difference(std::size_t span) const;
    double energy() const;
    double barrier(double mu) const;
    struct Local;
    Local local(std::size_t span, double mu) const;
    bool newton_step(double mu);

    CubicSpline spline_;
    double limit_;  // mm: the tolerance less the error of the path's cubics
    double path_error_;
    std::size_t first_;  // free control points
    std::size_t last_;
    std::vector<Row> rows_;
    std::vector<std::size_t> row_of_span_;      // first row of each; and the end
    std::vector<std::array<double, 4>> third_;  // d3 of spans
    std::vector<double> jerk_weight_;
};

}  // namespace curvecore::ref
