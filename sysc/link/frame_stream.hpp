// SPDX-License-Identifier: Apache-2.0
// A stream of frames that a board executes once each and in order, over a link that loses, doubles
// and delays (go-back-N): frames not known to be taken are sent again.
#pragma once

#include <array>
#include <deque>
#include <stdexcept>

#include "sysc/link/frame.hpp"
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

    /// Opens a session: the board then obeys this host alone. Before, it is only read. The first
    /// number must be one that no frame under way has, of another host or of this one before a
    /// restart.
    void open(std::uint32_t first);

    /// Begins a frame, which has its number.
    Frame begin() const;
    /// Returns true if one more frame may be under way.
    bool may_send() const { return under_way_.size() < window_; }
    /// Sends a frame with the number of words that it pushes. It is under way until a later answer;
    /// see all_taken().
    void send(const Frame& frame, int segment_words = 0, int profile_words = 0);
    bool all_taken() const { return under_way_.empty(); }
    /// Sets the period in which work() sends at least one numbered frame, for the board's watchdog.
    void live_each(WireClock::duration period) { live_period_ = period; }

    /// Handles answers and repeats overdue frames, for one wait of the link; requests the state
    /// when it is old.
    /// @throws BoardLost
    void work();
    /// Works until the board has taken all frames.
    void finish();

    const Telemetry& telemetry() const { return telemetry_; }
    const LinkFigures& figures() const { return figures_; }
    /// Reads words; repeats the question until they come.
    std::vector<std::uint32_t> read(std::uint32_t address, int words);

    /// Bytes of a frame that are not available to the caller.
    static constexpr std::size_t kOwnBytes = 2 * (kCommandBytes + 4) + 4 * kCommandBytes;

  private:
    /// Greatest number of frames under way: few on a slow line, so that urgent frames do not wait
    /// behind them.
    static constexpr std::size_t kLineWindow = 16;
    static constexpr std::size_t kNetWindow = 64;

    /// Number of epochs. Each question belongs to one. When it is answered, a frame sent before its
    /// epoch began is either taken, or was lost or overtaken: it is then repeated at once, with the
    /// frames behind it. An epoch lasts until one of its questions is answered.
    static constexpr std::size_t kEpochs = 5;

    struct UnderWay {
        std::uint32_t number;
        Frame frame;  // frame without its reads
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
    int polls_ = 0;  // questions since then
    WireClock::duration live_period_ = std::chrono::hours(1);
    WireClock::time_point waits_since_;
    bool waits_ = false;  // true: nothing was answered since then
    std::size_t question_ = 0;
    std::size_t epoch_ = 0;
    std::array<std::uint32_t, kEpochs> reach_{};  // by epoch: lower numbers were sent before it
    double deviation_s_ = 0.05;                   // deviation of the round trip
    int backoff_ = 1;
};

}  // namespace curvecore::sysc
