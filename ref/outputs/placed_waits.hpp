// SPDX-License-Identifier: Apache-2.0
// Waits of a program for a person, at places of its plan: M0, M6 and M60.
//
// The board draws up to a wait as if the program ended there, and begins the rest as another one.
// Dwells that the program asks for before a wait are before it, and those behind are behind; of
// several waits at one place, those between are before all of them.
#pragma once

#include <deque>
#include <optional>

#include "ref/moves/events.hpp"
#include "ref/moves/move.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// Returns true if a program waits for a person at this code.
bool waits_for_person(const std::string& code);

/// Returns the line of the first wait before this length, mm; 0: there is none.
int first_wait(const Events& events, double length);

class PlacedWaits {
  public:
    /// Adds a drawn move, with the events up to its end.
    void add(const Move& move, const Events& events);

    /// Gives the next part its waits, and ends programs there; all moves of its segments have been
    /// added. No wait is behind the last move.
    void place(Plan& part);

  private:
    struct Wait {
        std::optional<std::size_t> behind;  // a move; none: before the first one
        Vec3 end;                           // of that move, mm
        double rest;                        // s, of dwells before it
        PlannedWait wait;
    };

    bool ends(const Plan& part, std::size_t index);
    void end(Plan& part, Segment& segment);
    void rest(Plan& part);
    void split(Plan& part) const;
    void put(Plan& part);

    std::size_t taken_ = 0;
    double tool_ = 0;
    std::size_t moves_ = 0;
    std::deque<Wait> waits_;
    std::size_t segments_ = 0;         // of the part, up to the last end of a program
    std::size_t piece_ = 0;            // next one of the part
    std::uint64_t path_ = 0;           // before it, quanta
    std::uint64_t segment_ticks_ = 0;  // since the last end of a program
    std::uint64_t piece_ticks_ = 0;
    std::int64_t owed_ticks_ = 0;   // that the next segment has less
    std::uint64_t rest_ticks_ = 0;  // of the dwell before the next wait, not yet passed
    bool ended_ = false;            // a program, and its waits are not put yet
};

}  // namespace curvecore::ref
