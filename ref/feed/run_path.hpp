// SPDX-License-Identifier: Apache-2.0
// The path of a run as its limits see it, from knot to knot, and what a motion takes of them.
#pragma once

#include <vector>

#include "ref/feed/path_interval.hpp"
#include "ref/feed/path_places.hpp"
#include "ref/feed/run_knots.hpp"

namespace curvecore::ref {

class RunPath {
  public:
    RunPath(const std::vector<RunMove>& moves, const Geometry& geometry, const Machine& machine,
            PathPlaces& places);

    /// From one knot to the next. A curve may stand still at an end of the run: nothing is asked
    /// there.
    PathInterval interval(const std::vector<RunKnot>& knots, std::size_t k);

    /// Where in a phase loads are looked at.
    struct Part {
        bool first, last;  // of the run
        int places;
    };
    /// Of acceleration and jerk, the most that a phase takes of the limits' shares.
    double load(const Phase& phase, const Part& part);
    /// Of the velocity, on moves and where they join.
    double speed_load(const Phase& phase, int places) const;

  private:
    std::size_t move_at(long double s) const;
    std::vector<PlaceLimit> limits(long double s);
    PathInterval resting(PathInterval interval, long double rest, long double moving);

    const std::vector<RunMove>& moves_;
    const Geometry& geometry_;
    const Machine& machine_;
    PathPlaces& places_;
    std::vector<long double> begin_;  // of moves, mm
};

}  // namespace curvecore::ref
