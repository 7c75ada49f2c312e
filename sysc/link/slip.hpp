// SPDX-License-Identifier: Apache-2.0
// Frames on a stream of bytes: SLIP (RFC 1055) around a frame and its CRC-32, low byte first. The
// other end: rtl/line/slip_receiver.sv, slip_sender.sv. Two escapes are no byte:
// rtl/line/spi_line.sv says them inside a frame that has to wait.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace curvecore::sysc {

using Bytes = std::vector<std::uint8_t>;

/// Ends a frame; alone it says nothing.
constexpr std::uint8_t kSlipEnd = 0xc0;

Bytes slip_encode(const Bytes& frame);

class SlipDecoder {
  public:
    /// A frame that this byte ends, if it is whole and unbroken.
    std::optional<Bytes> take(std::uint8_t byte);

  private:
    Bytes held_;
    bool escaped_ = false;
    bool broken_ = false;
};

}  // namespace curvecore::sysc
