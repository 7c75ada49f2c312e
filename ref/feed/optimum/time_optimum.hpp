// SPDX-License-Identifier: Apache-2.0
// The fastest motion along a path under limits of velocity, acceleration and jerk.
#pragma once

#include <vector>

#include "ref/feed/optimum/limited_places.hpp"

namespace curvecore::ref {

/// Minimises int ds / sqrt(q) over the quadratic splines q(s) = v^2 that keep the limits of
/// TimeBarrier, a part of the path at a time: what is not free stays, and ends the free part.
///
/// Method: logarithmic barrier, Newton's method with a banded Cholesky decomposition. Every iterate
/// keeps all limits, and the time falls from stage to stage. (Verscheure et al. 2009 for q(s); the
/// tangent of TimeBarrier as in Debrouwere et al. 2013; feasible iterates as in Tran-Dinh et al.)
class TimeOptimum {
  public:
    /// @param path at least 4 intervals
    /// @param start a motion at every knot, without acceleration at both ends: they stay
    TimeOptimum(std::vector<PathInterval> path, const std::vector<KnotMotion>& start);

    std::size_t intervals() const { return path_.size(); }
    const PathInterval& interval(std::size_t k) const { return path_[k]; }
    const SpeedSpline& spline() const { return spline_; }

    /// Control points from `first` on, and what the limits beside them take for their speeds.
    struct State {
        std::size_t first;
        std::vector<double> controls;
        std::vector<double> means;
    };
    State state(std::size_t first, std::size_t last) const;
    void restore(const State& state);

    /// What interval k takes of its limits of acceleration and jerk.
    double load(std::size_t k) const { return ref::load(path_, spline_, k); }

    /// And of its velocities.
    double speed_load(std::size_t k) const { return ref::speed_load(path_, spline_, k); }

    /// Interval k gets these shares of them.
    void ease(std::size_t k, double share, double speed);

    /// Slows the motion around every place where it breaks a limit, by no more than it takes there.
    /// Whether all limits are kept then: surely so if all of the path is free.
    bool slow_down(std::size_t first, std::size_t last);

    /// Control points first .. last - 1 are free.
    ///
    /// @param from, to shares of the time that the barrier may cost, at first and in the end
    void improve(std::size_t first, std::size_t last, double from, double to);

    /// After improve(.., to): the first of the free control points that would be elsewhere if the
    /// two after them, which stand still, were.
    std::size_t led_by_end(std::size_t first, std::size_t last, double to) const;

  private:
    std::vector<PathInterval> path_;
    SpeedSpline spline_;
};

}  // namespace curvecore::ref
