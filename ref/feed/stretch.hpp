// SPDX-License-Identifier: Apache-2.0
// The path from one stop to the next, and its motion.
#pragma once

#include <vector>

#include "ref/feed/feed_task.hpp"
#include "ref/feed/optimum/optimal_run.hpp"
#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/stops/slowed.hpp"

namespace curvecore::ref {

/// | field       | unit   | remark                                                   |
/// |-------------|--------|----------------------------------------------------------|
/// | dwell       | s      | before it                                                |
/// | first, last |        | planned moves                                            |
/// | start, end  | quanta | of the program's path                                    |
/// | given       |        | it begins with this motion; none: at rest                |
/// | lead        | mm     | a straight run to its speed, before it in the zones      |
/// | zones       |        | moves and, between them, joints                          |
/// | caps        | mm/s   | of zones, by the rule of windows                         |
/// | phases      |        | the motion; places from the stretch's start, mm          |
/// | changed     |        | its windows are to be checked                            |
struct Stretch {
    double dwell = 0;
    std::size_t first = 0, last = 0;
    std::uint64_t start = 0, end = 0;
    GivenRun given = {};
    double lead = 0;
    std::vector<Zone> zones = {};
    std::vector<double> caps = {};
    std::vector<Phase> phases = {};
    bool changed = true;
    bool looked_at = true;

    bool is_given() const { return first + given.moves > last; }
    std::size_t open() const { return first + given.moves; }  // the first move that is not given
    std::size_t zone_of(std::size_t move) const { return 2 * (move - first); }
    std::size_t joint_before(std::size_t move) const { return zone_of(move) - 1; }

    void cap(std::size_t zone, double velocity) {
        caps[zone] = std::min(caps[zone], velocity);
        zones[zone].velocity = std::min(zones[zone].velocity, velocity);
    }
};

/// Time between knots of a move, s, where the speed changes.
double knot_step(const PathShape& shape, const Machine& machine);

/// Length in mm.
inline double length_of(const PlannedMove& move, const PieceGrid& grid) {
    return static_cast<double>(move.length) * grid.quantum;
}

/// Start of a planned move, mm from the stretch's start; kEnd beyond the last one.
long double place_of(const Geometry& geometry, const Stretch& stretch, std::size_t move,
                     const PieceGrid& grid);

/// Cuts a path at its stops and solves the stretches between them: their motion, within the limits
/// of the machine, of the program and of the core.
class StretchSolver {
  public:
    /// @param slowed each planned move, for the core's queues; both outlive the solver
    StretchSolver(const FeedTask& task, const std::vector<Slowed>& slowed);

    /// Makes all stretches from the geometry, with their zones and without motion.
    std::vector<Stretch> cut_at_stops();

    /// Makes a stretch's motion from its zones: ramps over them, behind its given motion. Returns
    /// false if that cannot be continued.
    bool solve_by_rules(Stretch& stretch) const;

    /// Makes the optimum from a motion by rules, behind the given one up to planned move `end`,
    /// whose speed at its start stays.
    void improve(Stretch& stretch, std::size_t end);

    const PieceGrid& grid() const { return grid_; }
    /// Dwell after the last stretch, s.
    double last_dwell() const { return last_dwell_; }

  private:
    struct Rest {
        bool stop = false;
        double dwell = 0;
    };

    Rest rest(std::size_t first, std::size_t last) const;
    void set_zones(Stretch& stretch) const;
    bool one_line(const Stretch& stretch) const;
    double asked_speed(std::size_t i, double machine) const;
    double carried_jerk(std::size_t i, double v, double acceleration) const;
    Zone zone(std::size_t i) const;
    std::vector<RunMove> run_moves(const Stretch& stretch, std::size_t first,
                                   std::size_t end) const;
    /// Loads of the words of a motion, as ratios to what they may be.
    struct WordsLoad {
        std::vector<RunLoad> loads;   // those beyond it
        std::vector<double> highest;  // of each phase
    };
    WordsLoad words_load(const std::vector<RunMove>& moves, const std::vector<Phase>& phases);
    std::vector<RunLoad> place_ends(const std::vector<RunMove>& moves, std::vector<Phase>& phases);

    const FeedTask& task_;
    PathPlaces places_;
    PieceGrid grid_;
    std::vector<double> step_speed_;
    const std::vector<Slowed>& slowed_;
    std::vector<double> joint_speed_;  // mm/s before each planned move; 0: stop
    double last_dwell_ = 0;
};

}  // namespace curvecore::ref
