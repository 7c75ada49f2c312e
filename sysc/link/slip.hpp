// SPDX-License-Identifier: Apache-2.0
// Frames on a stream of bytes: SLIP (RFC 1055) around a frame and its CRC-32, low byte first. Other
// end: rtl/line/slip_receiver.sv, slip_sender.sv. Two escapes encode no byte: rtl/line/spi_line.sv
// sends them inside a frame that has to wait.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace curvecore::sysc {

using Bytes = std::vector<std::uint8_t>;

/// End of a frame; alone it has no meaning.
constexpr std::uint8_t kSlipEnd = 0xc0;

Bytes slip_encode(const Bytes& frame);

class SlipDecoder {
  public:
    /// Takes a byte and returns the frame that it ends, if the frame is whole and unbroken.
    std::optional<Bytes> take(std::uint8_t byte);

  private:
    Bytes held_;
    bool escaped_ = false;
    bool broken_ = false;
};

}  // namespace curvecore::sysc
