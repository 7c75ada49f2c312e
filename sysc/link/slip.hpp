// SPDX-License-Identifier: Apache-2.0
// Frames on a stream of bytes: hls/registers/board_line.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hls/registers/board_line.h"

namespace curvecore::sysc {

using Bytes = std::vector<std::uint8_t>;

inline Bytes slip_encode(const Bytes& frame) {
    Bytes line(2 * frame.size() + 9);
    const int size = curvecore_to_line(line.data(), frame.data(), static_cast<int>(frame.size()));
    line.resize(static_cast<std::size_t>(size));
    return line;
}

class SlipDecoder {
  public:
    /// Takes a byte and returns the frame that it ends, if the frame is whole and unbroken.
    std::optional<Bytes> take(std::uint8_t byte) {
        const int length = curvecore_from_line(&line_, byte);
        if (length == 0) return std::nullopt;
        return Bytes(line_.bytes, line_.bytes + length);
    }

  private:
    curvecore_line line_{};
};

}  // namespace curvecore::sysc
