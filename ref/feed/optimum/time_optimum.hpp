// SPDX-License-Identifier: Apache-2.0
// The fastest motion along a path under limits of velocity, acceleration and jerk.
#pragma once

#include <vector>

#include "ref/feed/optimum/limited_places.hpp"

namespace curvecore::ref {

/// Minimises int ds / sqrt(q) over the quadratic splines q(s) = v^2 that keep the limits of
/// TimeBarrier, a part of the path at a time: fixed control points end the free part.
///
/// Method: logarithmic barrier, Newton's method with a banded Cholesky decomposition. Every iterate
/// keeps all limits, and the time falls from stage to stage. (Verscheure et al. 2009 for q(s); the
/// tangent of TimeBarrier as in Debrouwere et al. 2013; feasible iterates as in Tran-Dinh et al.)
class TimeOptimum {
  public:
    /// @param path at least 4 intervals
    /// @param start a motion at every knot, without acceleration at both ends, which stay
    TimeOptimum(std::vector<PathInterval> path, const std::vector<KnotMotion>& start);

    std::size_t intervals() const { return path_.size(); }
    const PathInterval& interval(std::size_t k) const { return path_[k]; }
    const SpeedSpline& spline() const { return spline_; }

    /// Control points from `first` on, and the speed shares of the limits beside them.
    struct State {
        std::size_t first;
        std::vector<double> controls;
        std::vector<double> means;
    };
    State state(std::size_t first, std::size_t last) const;
    void restore(const State& state);

    /// Load of interval k on its limits of acceleration and jerk.
    double load(std::size_t k) const { return ref::load(path_, spline_, k); }

    /// Load of interval k on its velocities.
    double speed_load(std::size_t k) const { return ref::speed_load(path_, spline_, k); }

    /// Gives interval k these shares of them.
    void ease(std::size_t k, double share, double speed);

    /// Slows the motion around every place where it violates a limit, no more than needed there.
    /// Returns true if all limits are kept then, which is certain if all of the path is free.
    bool slow_down(std::size_t first, std::size_t last);

    /// Improves the motion with control points first .. last - 1 free.
    ///
    /// @param from, to shares of the time that the barrier may cost, at first and at last
    void improve(std::size_t first, std::size_t last, double from, double to);

    /// Returns, after improve(.., to), the first of the free control points that would move if the
    /// two fixed ones after them did.
    std::size_t led_by_end(std::size_t first, std::size_t last, double to) const;

  private:
    std::vector<PathInterval> path_;
    SpeedSpline spline_;
};

}  // namespace curvecore::ref
