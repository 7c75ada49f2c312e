// SPDX-License-Identifier: Apache-2.0
// A host's end of a link that waits for its board: hls/registers/board_link.h.
#pragma once

#include <stdexcept>
#include <vector>

#include "hls/registers/board_link.h"
#include "sysc/link/link.hpp"

namespace curvecore::sysc {

/// The board is missing, or is not the one that was there.
class BoardLost : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// State that the board reports in every answer.
struct Telemetry {
    std::uint32_t state = 0;
    std::uint32_t axes = 0;
    int segment_room = 0;  // words, less those of frames under way
    int profile_room = 0;
    std::uint64_t path = 0;
    double rate = 0;  // rate of time
};

struct LinkFigures {
    std::uint64_t frames = 0;
    std::uint64_t repeated = 0;
    double round_trip_s = 0;
};

class FrameStream {
  public:
    /// Connects to the board. @throws BoardLost: no answer, or not a board of this kind
    explicit FrameStream(Link& link);

    /// Returns what the board is; its registers may be of another version.
    const curvecore_board& board() const { return state_.board; }

    /// Opens a session: the board then obeys this host alone. Before, it is only read. The first
    /// number must be one that no frame under way has, of another host or of this one before a
    /// restart.
    void open(std::uint32_t first);

    /// Begins a frame, which has its number.
    curvecore_frame* begin() { return curvecore_begin(&state_); }
    /// Returns true if one more frame may be under way.
    bool may_send() const { return curvecore_may_send(&state_) != 0; }
    /// Sends the frame begun, with the number of words that it pushes. It is under way until a
    /// later answer; see all_taken().
    void send(int segment_words = 0, int profile_words = 0);
    bool all_taken() const { return state_.count == 0; }
    /// Returns true if frames with words are under way.
    bool words_under_way() {
        return curvecore_under_way(&state_, 0) + curvecore_under_way(&state_, 1) > 0;
    }
    /// Sets the period in which work() sends at least one numbered frame, for the board's watchdog.
    void live_each(WireClock::duration period);
    WireClock::duration live_period() const;

    /// Handles answers and repeats overdue frames, for one wait of the link; requests the state
    /// when it is old.
    /// @throws BoardLost
    void work();
    /// Works until the board has taken all frames.
    void finish();

    const Telemetry& telemetry() const { return telemetry_; }
    LinkFigures figures() const;
    /// Reads a word; repeats the question until it comes.
    std::uint32_t read(std::uint32_t address);

    /// Returns the greatest number of words in two pushes of a frame.
    std::size_t words_of_frame() const;

  private:
    std::int64_t now() const;
    void understand();

    Link& link_;
    std::vector<curvecore_sent> sent_;
    curvecore_link state_{};
    Telemetry telemetry_;
};

}  // namespace curvecore::sysc
