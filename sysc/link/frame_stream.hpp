// SPDX-License-Identifier: Apache-2.0
// Frames that a board obeys, each once and in order, over a link that loses, doubles and delays
// (go-back-N): what is not known to be taken is sent again.
#pragma once

#include <array>
#include <deque>
#include <stdexcept>

#include "sysc/link/frame.hpp"
#include "sysc/link/link.hpp"

namespace curvecore::sysc {

/// The board is not there, or is not the one that was there.
class BoardLost : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What the board says in every answer.
struct Telemetry {
    std::uint32_t state = 0;
    std::uint32_t axes = 0;
    int segment_room = 0;  // words, of which those of frames under way are taken off
    int profile_room = 0;
    std::uint64_t path = 0;
    double rate = 0;  // of time
};

struct LinkFigures {
    std::uint64_t frames = 0;
    std::uint64_t repeated = 0;
    double round_trip_s = 0;
};

class FrameStream {
  public:
    /// @throws BoardLost: nobody answers, or not a board of this kind
    explicit FrameStream(Link& link);

    /// Opens a session: of all hosts the board obeys this one. Before, it is only read. Its first
    /// number is one that no frame under way has: of another host, or of this one before a restart.
    void open(std::uint32_t first);

    /// A frame to fill; it has its number.
    Frame begin() const;
    /// Whether one more may be under way.
    bool may_send() const { return under_way_.size() < window_; }
    /// With the words that it pushes. It is under way until a later answer; see all_taken().
    void send(const Frame& frame, int segment_words = 0, int profile_words = 0);
    bool all_taken() const { return under_way_.empty(); }
    /// At least so often a frame with a number goes out, in work(): what the board's watchdog
    /// counts.
    void live_each(WireClock::duration period) { live_period_ = period; }

    /// Works off answers and repeats what is overdue, for one wait of the link; asks for the state
    /// when it is old.
    /// @throws BoardLost
    void work();
    /// Until the board has taken all.
    void finish();

    const Telemetry& telemetry() const { return telemetry_; }
    const LinkFigures& figures() const { return figures_; }
    /// Words, which are read until they come.
    std::vector<std::uint32_t> read(std::uint32_t address, int words);

    /// Bytes of a frame that are not the caller's.
    static constexpr std::size_t kOwnBytes = 2 * (kCommandBytes + 4) + 4 * kCommandBytes;

  private:
    /// Frames under way: a line as slow as its bytes has few, or what is urgent waits behind them.
    static constexpr std::size_t kLineWindow = 16;
    static constexpr std::size_t kNetWindow = 64;

    /// A question is of an epoch. What was sent before that began is taken when it is answered,
    /// or was lost or overtaken: then it goes again at once, and so do those behind it. An epoch
    /// lasts until one of its questions is answered.
    static constexpr std::size_t kEpochs = 5;

    struct UnderWay {
        std::uint32_t number;
        Frame frame;  // without its reads
        int segment_words;
        int profile_words;
        WireClock::time_point sent;
        bool repeated;
    };

    void transmit(const Bytes& frame);
    void take(const Bytes& answer);
    void measure(WireClock::duration round_trip);
    void repeat_overdue();
    void repeat();
    void begin_epoch();
    WireClock::duration unanswered() const;
    WireClock::duration patience() const;
    void check_silence() const;

    Link& link_;
    std::uint32_t next_ = 0;  // number of the next frame
    std::deque<UnderWay> under_way_;
    std::size_t window_;
    Telemetry telemetry_;
    LinkFigures figures_;
    WireClock::time_point transmitted_;
    WireClock::time_point numbered_ = link_.now();
    int polls_ = 0;  // since then
    WireClock::duration live_period_ = std::chrono::hours(1);
    WireClock::time_point waits_since_;
    bool waits_ = false;  // nothing was answered since then
    std::size_t question_ = 0;
    std::size_t epoch_ = 0;
    std::array<std::uint32_t, kEpochs> reach_{};  // numbers below this were sent before
    double deviation_s_ = 0.05;                   // of the round trip
    int backoff_ = 1;
};

}  // namespace curvecore::sysc
