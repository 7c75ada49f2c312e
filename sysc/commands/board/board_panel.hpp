// SPDX-License-Identifier: Apache-2.0
// Page of a virtual board: where its axes are, as its pins say. Who looks can ask for nothing.
#pragma once

#include <array>
#include <mutex>
#include <string>

#include "sysc/link/link.hpp"
#include "sysc/panel/page_server.hpp"
#include "sysc/panel/shown_points.hpp"
#include "sysc/virtual/board_server.hpp"

namespace curvecore::sysc {

class BoardPanel {
  public:
    /// Opens the page, and prints its address.
    /// @param web as PageServer takes it; fast: the board's time is not that of the wall
    /// @throws UsageError
    BoardPanel(const std::string& web, const BoardServer& server, bool fast);

    void see(const VirtualEdge& edge);
    /// Notes the places, and shows them when it is time to.
    void turn();

  private:
    static constexpr int kPwm = VirtualBoard::kOutputs - 1;

    void follow();
    void note(const std::string& text);
    void note_changes();
    double power();
    std::string status();

    const BoardServer& server_;
    const bool fast_;
    WishQueue none_;            // nobody is told the token
    mutable std::mutex mutex_;  // of points_
    ShownPoints points_;
    std::array<std::int64_t, VirtualBoard::kAxes> places_{};  // steps
    double way_ = 0;                                          // steps
    double shown_way_ = 0;
    unsigned outputs_ = 0;
    unsigned shown_outputs_ = 0;
    std::uint64_t risen_ = 0;    // clock from which on PWM is on, or counted
    std::uint64_t on_ = 0;       // clocks in which it was, since it was shown
    std::uint64_t counted_ = 0;  // clock from which on they count
    double power_ = 0;
    bool drives_on_ = false;
    WireClock::time_point shown_;
    PageServer page_;  // last member: its thread uses the others
};

}  // namespace curvecore::sysc
