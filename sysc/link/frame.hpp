// SPDX-License-Identifier: Apache-2.0
// Frames of accesses to a board's registers, LBP16 commands: rtl/line/frame_reader.sv.
#pragma once

#include <cstdint>
#include <vector>

#include "hls/registers/board_link.h"
#include "sysc/link/slip.hpp"

namespace curvecore::sysc {

/// Bytes of a frame at most: rtl/line/frame_port.sv.
constexpr std::size_t kLongestFrame = CURVECORE_LONGEST_FRAME;
/// Bytes of a command with its address, and of each word that is pushed.
constexpr std::size_t kCommandBytes = 4;
constexpr std::size_t kPushedBytes = 8;

/// A frame that is made, command by command.
class Frame {
  public:
    Frame& write(std::uint32_t address, std::uint32_t word);
    /// Words of 48 bits into the queue at this address.
    /// @pre at most 127, and they fit into a frame
    Frame& push(std::uint32_t address, const std::vector<std::uint64_t>& words);
    /// Words from this address on, which the answer has in this order.
    Frame& read(std::uint32_t address, int words);

    const Bytes& bytes() const { return bytes_; }
    /// Whether one more command with so many bytes of data fits.
    bool has_room(std::size_t bytes) const {
        return bytes_.size() + kCommandBytes + bytes <= kLongestFrame;
    }

  private:
    void command(unsigned flags, std::size_t number, std::uint32_t address);
    void word(std::uint32_t word);

    Bytes bytes_;
};

/// What a board makes of a frame.
struct FrameContents {
    bool whole = true;  // no command that cannot be
    bool writes = false;
    std::size_t words_read = 0;
};
FrameContents contents_of(const Bytes& frame);

/// The words of an answer.
std::vector<std::uint32_t> words_of(const Bytes& answer);

}  // namespace curvecore::sysc
