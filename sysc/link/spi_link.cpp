// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/spi_link.hpp"

#include <thread>

namespace curvecore::sysc {
namespace {

/// Bytes of a question for the board's answer: longer than the answer to most frames.
constexpr std::size_t kQuestion = 64;
/// Pause before a board without an answer is asked again.
constexpr auto kPause = std::chrono::milliseconds(1);

}  // namespace

std::optional<Bytes> SpiLink::receive(WireClock::duration wait) {
    const WireClock::time_point end = WireClock::now() + wait;
    while (answers_.empty()) {
        const WireClock::time_point now = WireClock::now();
        if (now >= end) return std::nullopt;
        exchange(Bytes(kQuestion, CURVECORE_LINE_END));
        if (answers_.empty()) std::this_thread::sleep_for(kPause);
    }
    Bytes answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
}

void SpiLink::exchange(const Bytes& bytes) {
    for (const std::uint8_t byte : bus_->exchange(bytes)) {
        if (std::optional<Bytes> frame = decoder_.take(byte)) answers_.push_back(*std::move(frame));
    }
}

}  // namespace curvecore::sysc
