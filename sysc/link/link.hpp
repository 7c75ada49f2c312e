// SPDX-License-Identifier: Apache-2.0
// A link: it carries frames to a board and its answers back; either may be lost, doubled or late.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "sysc/link/slip.hpp"

namespace curvecore::sysc {

using WireClock = std::chrono::steady_clock;

class Link {
  public:
    virtual ~Link() = default;

    virtual void send(const Bytes& frame) = 0;
    /// Returns an answer; waits for it for at most `wait`.
    virtual std::optional<Bytes> receive(WireClock::duration wait) = 0;
    /// Period in which a host without words requests the board's state.
    virtual WireClock::duration poll_period() const = 0;
    /// Rate of the link, bytes a second; 0: unknown.
    virtual double bytes_per_s() const { return 0; }
    /// Clock in which waits, patience and signs of life are counted.
    virtual WireClock::time_point now() const { return WireClock::now(); }
};

/// Default address of boards.
constexpr const char* kWireAddress = "127.0.0.1";
constexpr unsigned short kWirePort = 27181;  // the port of Mesa's boards

/// Splits ADDRESS[:PORT]: returns the port and leaves ADDRESS.
/// @throws UsageError
unsigned short take_port(std::string& address);

/// Names that open_link() takes; 115200 baud and 1000000 Hz when left out.
constexpr const char* kLinkNames = "udp:ADDRESS[:PORT], serial:DEVICE[@BAUD] or spi:DEVICE[@HERTZ]";

/// Opens a link. @throws UsageError: an invalid name, or one that cannot be opened
std::unique_ptr<Link> open_link(const std::string& name);

}  // namespace curvecore::sysc
