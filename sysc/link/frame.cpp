// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/frame.hpp"

namespace curvecore::sysc {
namespace {

constexpr unsigned kWrite = 0x8000;
constexpr unsigned kAddress = 0x4000;
constexpr unsigned kZeros = 0x3e00;
constexpr unsigned kWords = 0x0200;
constexpr unsigned kPair = 0x0100;
constexpr unsigned kPairs = kWords | kPair;
constexpr unsigned kIncrement = 0x0080;
constexpr unsigned kNumber = 0x007f;
constexpr unsigned kAddresses = 512;

}  // namespace

void Frame::command(unsigned flags, std::size_t number, std::uint32_t address) {
    const unsigned code = flags | kAddress | static_cast<unsigned>(number);
    for (const unsigned half : {code, static_cast<unsigned>(address)}) {
        bytes_.push_back(static_cast<std::uint8_t>(half));
        bytes_.push_back(static_cast<std::uint8_t>(half >> 8));
    }
}

void Frame::word(std::uint32_t word) {
    for (int n = 0; n < 4; ++n) bytes_.push_back(static_cast<std::uint8_t>(word >> 8 * n));
}

Frame& Frame::write(std::uint32_t address, std::uint32_t data) {
    command(kWrite | kWords, 1, address);
    word(data);
    return *this;
}

Frame& Frame::push(std::uint32_t address, const std::vector<std::uint64_t>& words) {
    command(kWrite | kPairs, words.size(), address);
    for (const std::uint64_t pushed : words) {
        word(static_cast<std::uint32_t>(pushed));
        word(static_cast<std::uint32_t>(pushed >> 32));
    }
    return *this;
}

Frame& Frame::read(std::uint32_t address, int words) {
    command(kWords | kIncrement, static_cast<std::size_t>(words), address);
    return *this;
}

FrameContents contents_of(const Bytes& frame) {
    FrameContents contents;
    std::size_t at = 0;
    const auto half = [&] {
        const unsigned low = at < frame.size() ? frame[at] : 0;
        const unsigned high = at + 1 < frame.size() ? frame[at + 1] : 0;
        at += 2;
        contents.whole = at <= frame.size();
        return low | high << 8;
    };
    while (contents.whole && at < frame.size()) {
        const unsigned code = half();
        const bool pairs = (code & kPair) != 0;
        contents.whole = contents.whole && (code & kZeros) == kWords;
        if (contents.whole && (code & kAddress) != 0) {
            const unsigned address = half();
            contents.whole =
                contents.whole && address < kAddresses && address % (pairs ? 8 : 4) == 0;
        }
        if (!contents.whole) break;
        const std::size_t words = (code & kNumber) << (pairs ? 1 : 0);
        if ((code & kWrite) != 0) {
            contents.writes = true;
            at += 4 * words;
            contents.whole = at <= frame.size();
        } else {
            contents.words_read += words;
        }
    }
    if (!contents.whole) ++contents.words_read;  // the answer is STATE
    return contents;
}

std::vector<std::uint32_t> words_of(const Bytes& answer) {
    std::vector<std::uint32_t> words(answer.size() / 4);
    for (std::size_t n = 0; n < 4 * words.size(); ++n) {
        words[n / 4] |= std::uint32_t{answer[n]} << 8 * (n % 4);
    }
    return words;
}

}  // namespace curvecore::sysc
