// SPDX-License-Identifier: Apache-2.0
// Frames over SPI as rtl/line/spi_line.sv has them: SLIP's bytes both ways at once.
//
//     to the board     | frame .. end | end end end end end end end ..
//     from the board   | end end ..   | answer .. end | end end ..
//
// Only the host has a clock: the board's answer comes out while the host sends, or while it sends
// idle bytes to ask for it.
#pragma once

#include <deque>

#include "sysc/link/link.hpp"

namespace curvecore::sysc {

class SpiBus {
  public:
    virtual ~SpiBus() = default;

    /// Exchanges bytes with the chip select low from the first bit to the last; returns as many.
    virtual Bytes exchange(const Bytes& bytes) = 0;
};

class SpiLink : public Link {
  public:
    SpiLink(std::unique_ptr<SpiBus> bus, double hertz) : bus_(std::move(bus)), hertz_(hertz) {}

    void send(const Bytes& frame) override { exchange(slip_encode(frame)); }
    std::optional<Bytes> receive(WireClock::duration wait) override;
    WireClock::duration poll_period() const override { return std::chrono::milliseconds(20); }
    double bytes_per_s() const override { return hertz_ / 8; }

  private:
    void exchange(const Bytes& bytes);

    std::unique_ptr<SpiBus> bus_;
    double hertz_;
    SlipDecoder decoder_;
    std::deque<Bytes> answers_;
};

/// Opens Linux' spidev, mode 0.
/// @throws boost::system::system_error: no such device, or it has no such clock
std::unique_ptr<SpiBus> open_spi_device(const std::string& device, unsigned hertz);

}  // namespace curvecore::sysc
