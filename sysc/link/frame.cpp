// SPDX-License-Identifier: Apache-2.0
#include "sysc/link/frame.hpp"

#include "hls/registers/board_frame.h"

namespace curvecore::sysc {
namespace {

/// Bits that are those of CURVECORE_COMMAND_WORDS in every command.
constexpr unsigned kFixed = 0x3e00;
constexpr unsigned kAddresses = 512;

}  // namespace

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
        const bool pairs = (code & CURVECORE_COMMAND_PAIRS) == CURVECORE_COMMAND_PAIRS;
        contents.whole = contents.whole && (code & kFixed) == CURVECORE_COMMAND_WORDS;
        if (contents.whole && (code & CURVECORE_COMMAND_ADDRESS) != 0) {
            const unsigned address = half();
            contents.whole =
                contents.whole && address < kAddresses && address % (pairs ? 8 : 4) == 0;
        }
        if (!contents.whole) break;
        const std::size_t words = (code & CURVECORE_COMMAND_NUMBER) << (pairs ? 1 : 0);
        if ((code & CURVECORE_COMMAND_WRITE) != 0) {
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

}  // namespace curvecore::sysc
