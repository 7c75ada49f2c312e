// SPDX-License-Identifier: Apache-2.0
// The list of a program's moves while they are made, for every reader: stops and dwells behind
// them, curves in pieces, warnings that are counted.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ref/gcode/blocks/block.hpp"
#include "ref/moves/events.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

constexpr double kSmallestTolerance = 1e-5;  // mm, of G64
constexpr double kLargestTolerance = 10;     // mm
constexpr double kLongestDwell = 86400;      // s

class MoveList {
  public:
    explicit MoveList(const std::string& file) { program_.file = file; }

    const std::string& file() const { return program_.file; }

    /// Returns true if the move has a length; if not, a warning reports that it is left out.
    bool moves(const Move& move, const Place& place);
    void append(const Move& move);
    /// Cuts a curve into pieces; `whole` has all that is the same for each.
    /// @throws InputError if nothing is left of it
    std::vector<Move> pieces_of(const std::vector<Cubic>& cubics, const Move& whole,
                                const Place& place);
    /// Stops behind the last move.
    void stop();
    /// Rests behind the last move; before the first one, behind a move of no length.
    void dwell(double seconds, const Place& place);
    void warn(const std::string& text, const Place& place);
    /// Obeys these codes: no warning names them.
    void obey(const Obeyed& codes) { obeys_ = codes; }
    /// Records a code that asks for more than motion, such as M3, as an event; one warning names
    /// all that are not obeyed. It also names those whose value, as S, holds `along_path` and
    /// changes where the path goes on.
    void leave_out(const std::string& code, const Place& place, double value = 0,
                   bool along_path = false);

    const Events& events() const { return events_; }

    /// Hands over moves in order; also the `last` one, behind which a stop or a dwell may still
    /// come.
    std::vector<Move> take(bool last);
    /// Returns the rest of the program, with all of its warnings. @throws InputError if it has no
    /// moves
    Program finish();

  private:
    struct Warning {
        int line;
        int count;
    };

    struct LeftOut {
        std::vector<int> lines;  // the first ones
        int count = 0;
        double value = 0;
        bool changed = false;  // since the last move
        bool changes = false;  // between two moves without a stop
    };

    void note_values(bool stopped);
    void warn_of_left_out();

    Program program_;
    Move first_;  // of no length, for a dwell before the first move
    Events events_;
    Obeyed obeys_;
    std::map<std::string, Warning> warnings_;
    std::map<std::string, LeftOut> left_out_;
    double length_ = 0;           // mm, of all moves
    bool value_changed_ = false;  // one of them has, since the last move
};

/// Converts a feed in mm/min to mm/s. @throws InputError out of range
double feed_of(double per_minute, const Place& place);

}  // namespace curvecore::ref
