// SPDX-License-Identifier: Apache-2.0
// The path of a run as its limits see it, from knot to knot, and the load of a motion on it.
#pragma once

#include <vector>

#include "ref/feed/optimum/run_knots.hpp"
#include "ref/feed/places/path_interval.hpp"
#include "ref/feed/places/path_places.hpp"

namespace curvecore::ref {

/// Loads, as shares of the limits of acceleration and jerk, and of velocities on moves and at their
/// joints.
struct RunLoads {
    double load = 0;
    double speed = 0;
};

/// The run, cut into intervals by knots. Limits are checked at the same places of each, whatever
/// the motion: they are found once.
class RunPath {
  public:
    RunPath(const std::vector<RunMove>& moves, const Geometry& geometry, const Machine& machine,
            PathPlaces& places, const std::vector<RunKnot>& knots);

    /// The interval from knot k to the next. If the curve stands still at an end of the run,
    /// nothing is checked there.
    PathInterval interval(std::size_t k) const;

    /// The jerk along the path that the machine allows at knot k.
    double jerk_along(std::size_t k) const;

    /// The largest loads of a phase that lasts from knot `first` to knot `end`; the search ends
    /// above `most`.
    RunLoads loads(const Phase& phase, std::size_t first, std::size_t end,
                   const RunLoads& most) const;

  private:
    /// | field    | remark                                                             |
    /// |----------|--------------------------------------------------------------------|
    /// | part     | of the interval, in quarters of its time; -1: beside a joint in it |
    /// | velocity | mm/s, limit of its move and the machine                            |
    /// | jerk     | mm/s^3 along the path, limit of the machine                        |
    /// | limits   | index of the first                                                 |
    struct Look {
        long double s;
        int part;
        std::size_t move;
        double velocity;
        double jerk;
        std::size_t limits;
    };

    std::size_t count() const { return knots_.size() - 1; }
    bool starts(std::size_t k) const { return k == 0 && knots_.front().v == 0; }
    bool ends(std::size_t k) const { return k + 1 == count() && knots_.back().v == 0; }
    std::size_t move_at(long double s) const;
    void look_at(std::size_t k);
    void add(long double s, int part, std::size_t move);
    std::size_t limits_end(std::size_t look) const {
        return look + 1 < looks_.size() ? looks_[look + 1].limits : limits_.size();
    }
    bool bends(std::size_t look) const;
    bool changes(std::size_t k) const;
    void add_places(std::size_t look, PathInterval& interval, long double from, bool acceleration,
                    bool jerk) const;
    void add_resting(std::size_t look, PathInterval& interval, double x) const;

    const std::vector<RunMove>& moves_;
    const Geometry& geometry_;
    const Machine& machine_;
    PathPlaces& places_;
    const std::vector<RunKnot>& knots_;
    std::vector<long double> begin_;  // mm, starts of moves
    std::vector<Look> looks_;
    std::vector<std::size_t> first_look_;  // first look of each interval; and the end
    std::vector<PlaceLimit> limits_;
};

}  // namespace curvecore::ref
