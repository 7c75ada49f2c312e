// SPDX-License-Identifier: Apache-2.0
// Frames of accesses to a board's registers, as LBP16 commands: rtl/line/frame_reader.sv.
#pragma once

#include <cstdint>
#include <vector>

#include "hls/registers/board_link.h"
#include "sysc/link/slip.hpp"

namespace curvecore::sysc {

/// Greatest number of bytes of a frame: rtl/line/frame_port.sv.
constexpr std::size_t kLongestFrame = CURVECORE_LONGEST_FRAME;
/// Bytes of a command with its address, and of each word that is pushed.
constexpr std::size_t kCommandBytes = 4;
constexpr std::size_t kPushedBytes = 8;

/// A frame, made command by command.
class Frame {
  public:
    Frame& write(std::uint32_t address, std::uint32_t word);
    /// Pushes words of 48 bits into the queue at this address.
    /// @pre at most 127, and they fit into a frame
    Frame& push(std::uint32_t address, const std::vector<std::uint64_t>& words);
    /// Reads words from this address on; the answer has them in this order.
    Frame& read(std::uint32_t address, int words);

    const Bytes& bytes() const { return bytes_; }
    /// Returns true if one more command with `bytes` bytes of data fits.
    bool has_room(std::size_t bytes) const {
        return bytes_.size() + kCommandBytes + bytes <= kLongestFrame;
    }

  private:
    void command(unsigned flags, std::size_t number, std::uint32_t address);
    void word(std::uint32_t word);

    Bytes bytes_;
};

/// Contents of a frame as a board reads it.
struct FrameContents {
    bool whole = true;  // no invalid command
    bool writes = false;
    std::size_t words_read = 0;
};
FrameContents contents_of(const Bytes& frame);

/// Returns the words of an answer.
std::vector<std::uint32_t> words_of(const Bytes& answer);

}  // namespace curvecore::sysc
