// SPDX-License-Identifier: Apache-2.0
// Outputs of a program at places of its plan.
#pragma once

#include <deque>
#include <string>

#include "ref/outputs/output_course.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

class PlacedOutputs {
  public:
    /// @param raised times by which an override raises the feeds of moves
    /// @param most changes that wait at the board; 0: it has no outputs
    /// @param known nothing is on where the moves begin
    PlacedOutputs(const OutputRules& rules, double raised, int most, double sample_s,
                  std::string file, bool known = true)
        : course_(rules, known),
          raised_(raised),
          waiting_words_(most),
          sample_s_(sample_s),
          file_(std::move(file)) {}

    /// Adds a drawn move, with the events before its end.
    void add(const Move& move, const Events& events);
    /// Adds what is left at the end of the last move.
    void end(const Events& events);

    /// Gives the next part its outputs; all moves of its segments have been added.
    /// @throws InputError: more changes than the board's queue keeps in the time of two stops, or
    /// samples too short or too long for outputs to count their way
    void place(Plan& part);

  private:
    struct Change {
        std::size_t move;
        double length;  // mm of it before the change
        bool dwelt;     // it is behind a dwell
        PlannedOutput output;
    };

    void add(const std::vector<OutputCourse::Change>& changes, double length);
    void check_room(const Plan& part);
    void check_ways(const Plan& part) const;

    OutputCourse course_;
    double raised_;
    int waiting_words_;
    double sample_s_;
    std::string file_;
    std::size_t moves_ = 0;
    std::deque<Change> changes_;
    std::deque<PlannedOutput> placed_;  // beyond the parts that are given
    std::uint64_t path_ = 0;            // end of these, quanta
    double ticks_ = 0;
    std::deque<double> times_;  // of the last changes, ticks
};

}  // namespace curvecore::ref
