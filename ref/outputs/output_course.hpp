// SPDX-License-Identifier: Apache-2.0
// Outputs along a program's moves, by its codes of spindle, coolant and outputs.
//
//   | bit    | on                                                        |
//   |--------|-----------------------------------------------------------|
//   | 0      | M3, M4 until M5: the spindle turns, or the laser is ready |
//   | 1      | M4, unless it is a laser: counter-clockwise               |
//   | 2, 3   | M7, M8 until M9: mist, flood                              |
//   | 4 .. 7 | M62, M64 P0 to P3, until M63, M65                         |
//
// The level is S of `full`, while bit 0 is on; or Q of M67 and M68 E0. A laser's is 0 in rapids and
// while bit 0 is off, and with M4 it follows the speed along the path, whole at the feed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ref/moves/events.hpp"
#include "ref/moves/move.hpp"
#include "ref/plan/planned_output.hpp"

namespace curvecore::ref {

struct OutputRules {
    double full = 1000;  // S at which the level is whole
    double full_q = 0;   // Q at which it is, if above 0; S has no effect then
    bool laser = false;
    bool dark_at_rest = false;  // a laser with M3 has no level while the axes rest
};

/// Returns true if outputs obey this code; `analog`: full_q is above 0.
bool switches_outputs(const std::string& code, bool analog);

class OutputCourse {
  public:
    /// Rests between the end of the move before and a change: the program's waits so far, and a
    /// dwell, where it waits for nobody there.
    struct Behind {
        int waits = 0;
        bool dwell = false;
    };
    /// A change at a place of a move; in the motion after it, where a dwell is between.
    struct Change {
        OutputKind kind;
        double value;
        double share;  // of the move's length that is before it
        Behind behind;
        int line;
    };

    /// @param known nothing is on where the moves begin; otherwise that may be anything
    explicit OutputCourse(const OutputRules& rules, bool known = true) : rules_(rules) {
        if (known) given_ = State();
    }

    /// Returns the changes in the next drawn move, in order; `events`: those before its end.
    std::vector<Change> next(const Move& move, const Events& events);
    /// Returns those at the end of the last move, behind which nothing but bits 4 to 7 stays on.
    std::vector<Change> end(const Events& events);

  private:
    struct State {
        int bits = 0;
        double level = 0;
        double follow = 0;
    };

    bool comes(const Events& events, double length) const;
    bool stays(const Events& events, double length) const;
    Events::Event take(const Events& events);
    void obey(const Events& events, const Events::Event& event);
    void begin(const Move& move, const Events& events, std::vector<Change>& changes);
    void note(std::vector<Change>& changes, const State& state, double share, Behind behind,
              int line);
    State state(const Move& move) const;

    OutputRules rules_;
    std::size_t taken_ = 0;
    int waits_ = 0;
    int bits_ = 0;                // as asked for
    double asked_ = 0;            // S or Q
    std::optional<State> given_;  // none: not known
};

}  // namespace curvecore::ref
