// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/frame_stream.hpp"

#include <algorithm>

#include "hls/registers/registers.h"

namespace curvecore::sysc {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

/// Silence after which the board counts as lost. A busy computer may be silent for seconds, and its
/// board holds meanwhile.
constexpr auto kSilence = std::chrono::seconds(10);
/// Time without an answer after which another question is sent, while no round trip is known.
constexpr WireClock::duration kUnanswered = milliseconds(25);
/// Greatest number of questions without a number between two with one: frames advance a fast
/// board's clock.
constexpr int kMostPolls = 20;
/// Greatest number of frames repeated at once: where many are lost, few are taken before the next
/// that is missing.
constexpr std::size_t kMostRepeated = 16;
/// Greatest lag of an answer's number; an answer further off is of another session.
constexpr std::int32_t kLate = 1 << 20;

/// Adds the reads that end every frame, in the order of take(); the answer's length gives the
/// epoch.
Frame with_reads(Frame frame, std::size_t epoch) {
    frame.read(CURVECORE_STATE, 2).read(CURVECORE_PATH_LO, 4).read(CURVECORE_SEQUENCE, 1);
    return frame.read(CURVECORE_ID, static_cast<int>(epoch) + 1);
}
constexpr std::size_t kWordsRead = 7;
constexpr std::size_t kQuestions = 16;

/// A frame that is executed if the board's number is `before`, which becomes `after`.
Frame numbered(std::uint32_t before, std::uint32_t after) {
    Frame frame;
    frame.write(CURVECORE_EXPECT, before).write(CURVECORE_SEQUENCE, after);
    return frame;
}

WireClock::duration seconds(double s) {
    return std::chrono::duration_cast<WireClock::duration>(duration<double>(s));
}

}  // namespace

FrameStream::FrameStream(Link& link)
    : link_(link), window_(link.bytes_per_s() == 0 ? kNetWindow : kLineWindow) {
    const std::uint32_t id = read(CURVECORE_ID, 1)[0];
    if (id != CURVECORE_ID_ID_VALUE) throw BoardLost("what answers is not a motion_board");
}

void FrameStream::open(std::uint32_t first) {
    while (next_ != first) {
        const std::uint32_t number = read(CURVECORE_SEQUENCE, 1)[0];
        transmit(numbered(number, first).bytes());
        next_ = read(CURVECORE_SEQUENCE, 1)[0];
    }
    reach_.fill(next_);
    work();
}

std::vector<std::uint32_t> FrameStream::read(std::uint32_t address, int words) {
    // Answers do not name their question; a question's length, its number of words ID, tells it
    // from the ones before.
    question_ = (question_ + 1) % kQuestions;
    const std::size_t marks = kWordsRead + kEpochs + 1 + question_;
    Frame frame;
    frame.read(address, words);
    for (std::size_t n = 0; n < marks; ++n) frame.read(CURVECORE_ID, 1);
    for (;;) {
        transmit(frame.bytes());
        const WireClock::time_point end = link_.now() + patience();
        while (link_.now() < end) {
            const std::optional<Bytes> answer = link_.receive(end - link_.now());
            if (!answer) continue;
            waits_ = false;
            std::vector<std::uint32_t> read = words_of(*answer);
            if (read.size() != static_cast<std::size_t>(words) + marks) continue;
            read.resize(static_cast<std::size_t>(words));
            return read;
        }
        check_silence();
    }
}

Frame FrameStream::begin() const { return numbered(next_, next_ + 1); }

void FrameStream::transmit(const Bytes& frame) {
    link_.send(frame);
    ++figures_.frames;
    transmitted_ = link_.now();
    if (!waits_) waits_since_ = transmitted_;
    waits_ = true;
}

void FrameStream::check_silence() const {
    if (waits_ && link_.now() > waits_since_ + kSilence) {
        throw BoardLost("the board does not answer");
    }
}

void FrameStream::send(const Frame& frame, int segment_words, int profile_words) {
    transmit(with_reads(frame, epoch_).bytes());
    numbered_ = transmitted_;
    polls_ = 0;
    under_way_.push_back({next_++, frame, segment_words, profile_words, transmitted_, false});
    telemetry_.segment_room -= segment_words;
    telemetry_.profile_room -= profile_words;
}

void FrameStream::work() {
    // Questions wait for answers, but not for long: a board stops if its host is silent.
    if (all_taken() && (polls_ >= kMostPolls || link_.now() >= numbered_ + live_period_)) {
        send(begin());
    } else if (link_.now() >= transmitted_ + (waits_ ? unanswered() : link_.poll_period())) {
        transmit(with_reads({}, epoch_).bytes());
        ++polls_;
    }
    WireClock::duration wait = link_.poll_period();
    while (const std::optional<Bytes> answer = link_.receive(wait)) {
        take(*answer);
        wait = WireClock::duration::zero();
    }
    repeat_overdue();
    check_silence();
}

void FrameStream::finish() {
    while (!all_taken()) work();
}

void FrameStream::take(const Bytes& answer) {
    const std::vector<std::uint32_t> words = words_of(answer);
    if (words.size() <= kWordsRead || words.size() > kWordsRead + kEpochs) return;  // of read()
    const std::size_t epoch = words.size() - kWordsRead - 1;
    waits_ = false;
    const std::uint32_t first = next_ - static_cast<std::uint32_t>(under_way_.size());
    const auto taken = static_cast<std::int32_t>(words[6] - first);
    if (taken < 0 && taken > -kLate) return;  // late
    if (taken < 0 || taken > static_cast<std::int32_t>(under_way_.size())) {
        throw BoardLost("the board was restarted, or has another master");
    }
    for (std::int32_t n = 0; n < taken; ++n) {
        if (!under_way_.front().repeated) measure(link_.now() - under_way_.front().sent);
        under_way_.pop_front();
        backoff_ = 1;
    }
    telemetry_.state = words[0];
    telemetry_.axes = words[1];
    telemetry_.segment_room = static_cast<int>(words[5] & 0xffff);
    telemetry_.profile_room = static_cast<int>(words[5] >> 16);
    for (const UnderWay& frame : under_way_) {
        telemetry_.segment_room -= frame.segment_words;
        telemetry_.profile_room -= frame.profile_words;
    }
    telemetry_.path = std::uint64_t{words[3]} << 32 | words[2];
    telemetry_.rate = words[4] / 65536.0;
    // This question was sent after the first frame under way, and did not find it taken.
    if (!all_taken() && static_cast<std::int32_t>(reach_[epoch] - under_way_.front().number) > 0) {
        repeat();
    } else if (epoch == epoch_) {
        begin_epoch();
    }
}

void FrameStream::begin_epoch() {
    epoch_ = (epoch_ + 1) % kEpochs;
    reach_[epoch_] = next_;
}

/// Updates the round trip by the estimate of Jacobson and Karels.
void FrameStream::measure(WireClock::duration round_trip) {
    const double seen = duration<double>(round_trip).count();
    double& mean = figures_.round_trip_s;
    if (mean == 0) mean = seen;
    deviation_s_ += (std::abs(seen - mean) - deviation_s_) / 4;
    mean += (seen - mean) / 8;
}

/// Two round trips, so that questions do not flood a slow board.
WireClock::duration FrameStream::unanswered() const {
    const double mean = figures_.round_trip_s;
    return mean == 0 ? kUnanswered : std::max(2 * link_.poll_period(), seconds(2 * mean));
}

WireClock::duration FrameStream::patience() const {
    const double mean = figures_.round_trip_s;
    return std::max<WireClock::duration>(
        {2 * link_.poll_period(), kUnanswered, seconds(backoff_ * (mean + 4 * deviation_s_))});
}

void FrameStream::repeat_overdue() {
    if (under_way_.empty() || link_.now() < under_way_.front().sent + patience()) return;
    repeat();
    backoff_ = std::min(2 * backoff_, 4);
}

void FrameStream::repeat() {
    std::size_t left = kMostRepeated;
    for (UnderWay& frame : under_way_) {
        frame.repeated = true;
        if (left == 0) continue;
        --left;
        transmit(with_reads(frame.frame, epoch_).bytes());
        frame.sent = transmitted_;
        ++figures_.repeated;
    }
    // Earlier questions do not tell whether these are taken.
    reach_.fill(under_way_.front().number);
    begin_epoch();
}

}  // namespace curvecore::sysc
