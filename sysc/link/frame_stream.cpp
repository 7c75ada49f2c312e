// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/frame_stream.hpp"

namespace curvecore::sysc {
namespace {

using std::chrono::nanoseconds;

/// Silence after which there is no board. A busy computer may be silent for seconds, and its board
/// holds meanwhile.
constexpr nanoseconds kSilence = std::chrono::seconds(10);
/// The same for a board that obeys another host, which a virtual board lets go when it is silent.
constexpr nanoseconds kOthers = std::chrono::seconds(60);
/// Greatest number of frames under way: few on a slow line, or urgent ones wait behind them.
constexpr int kLineWindow = 16;
constexpr int kNetWindow = 64;

void transmit(void* device, const std::uint8_t* bytes, int length) {
    static_cast<Link*>(device)->send(Bytes(bytes, bytes + length));
}

std::int64_t count_of(WireClock::duration time) {
    return std::chrono::duration_cast<nanoseconds>(time).count();
}

}  // namespace

FrameStream::FrameStream(Link& link)
    : link_(link), sent_(link.bytes_per_s() == 0 ? kNetWindow : kLineWindow) {
    curvecore_start(&state_, transmit, &link_, sent_.data(), static_cast<int>(sent_.size()));
    state_.poll_period = count_of(link.poll_period());
    // In the order of understand()
    curvecore_read_always(&state_, CURVECORE_STATE, 2);
    curvecore_read_always(&state_, CURVECORE_PATH_LO, 4);
    while (state_.board.id == 0) work();
    if (state_.board.id != CURVECORE_ID_ID_VALUE) {
        throw BoardLost("what answers is not a motion_board");
    }
}

void FrameStream::open(std::uint32_t first) {
    curvecore_open(&state_, first);
    while (state_.phase != CURVECORE_OPEN) work();
}

std::uint32_t FrameStream::read(std::uint32_t address) {
    curvecore_frame reads{};
    curvecore_read(&reads, address, 1);
    curvecore_ask(&state_, &reads, 1, now());
    while (state_.asks != 0) work();
    return state_.answer[0];
}

void FrameStream::send(int segment_words, int profile_words) {
    curvecore_send(&state_, segment_words, profile_words, now());
    telemetry_.segment_room -= segment_words;
    telemetry_.profile_room -= profile_words;
}

void FrameStream::live_each(WireClock::duration period) { state_.live_period = count_of(period); }

WireClock::duration FrameStream::live_period() const {
    return std::chrono::duration_cast<WireClock::duration>(nanoseconds(state_.live_period));
}

void FrameStream::work() {
    WireClock::duration wait = link_.poll_period();
    while (const std::optional<Bytes> answer = link_.receive(wait)) {
        const auto length = static_cast<int>(answer->size());
        const curvecore_news news = curvecore_take(&state_, answer->data(), length, now());
        if (news == CURVECORE_FOREIGN) {
            throw BoardLost("the board was restarted, or has another master");
        }
        if (news == CURVECORE_STATUS) understand();
        wait = WireClock::duration::zero();
    }
    curvecore_work(&state_, now());
    const bool opening = state_.opening != 0 && state_.phase == CURVECORE_KNOWN;
    if (curvecore_silence(&state_, now()) > (opening ? kOthers : kSilence).count()) {
        throw BoardLost(opening ? "the board obeys another host" : "the board does not answer");
    }
}

void FrameStream::finish() {
    while (!all_taken()) work();
}

void FrameStream::understand() {
    const std::uint32_t* words = state_.words;
    const std::uint32_t room = words[5];
    telemetry_.state = words[0];
    telemetry_.axes = words[1];
    telemetry_.path = std::uint64_t{words[3]} << 32 | words[2];
    telemetry_.rate = words[4] / 65536.0;
    telemetry_.segment_room =
        static_cast<int>(CURVECORE_FIELD(room, ROOM_SEGMENT)) - curvecore_under_way(&state_, 0);
    telemetry_.profile_room =
        static_cast<int>(CURVECORE_FIELD(room, ROOM_PROFILE)) - curvecore_under_way(&state_, 1);
}

LinkFigures FrameStream::figures() const {
    return {state_.frames, state_.repeated,
            std::chrono::duration<double>(nanoseconds(state_.round_trip)).count()};
}

std::size_t FrameStream::words_of_frame() const {
    curvecore_frame empty{};
    curvecore_number(&empty, 0, 0);
    const int room = curvecore_room(&state_, &empty) - 2 * CURVECORE_COMMAND_BYTES;
    return static_cast<std::size_t>(room / CURVECORE_PUSHED_BYTES);
}

std::int64_t FrameStream::now() const { return count_of(link_.now().time_since_epoch()); }

}  // namespace curvecore::sysc
