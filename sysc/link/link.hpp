// SPDX-License-Identifier: Apache-2.0
// What carries frames to a board, and its answers back; either may be lost, doubled or late.
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
    /// An answer, waited for so long.
    virtual std::optional<Bytes> receive(WireClock::duration wait) = 0;
    /// How often a host without words asks for the board's state.
    virtual WireClock::duration poll_period() const = 0;
    /// Bytes a second that it carries, 0: not known.
    virtual double bytes_per_s() const { return 0; }
    /// The time that waits, patience and signs of life are counted in.
    virtual WireClock::time_point now() const { return WireClock::now(); }
};

/// Where boards listen, if nothing else is said.
constexpr const char* kWireAddress = "127.0.0.1";
constexpr unsigned short kWirePort = 27181;  // Mesa's

/// The port of ADDRESS[:PORT], which is ADDRESS then.
/// @throws UsageError
unsigned short take_port(std::string& address);

/// What open_link() takes; 115200 baud and 1000000 Hz when left out.
constexpr const char* kLinkNames = "udp:ADDRESS[:PORT], serial:DEVICE[@BAUD] or spi:DEVICE[@HERTZ]";

/// @throws UsageError: what is not such a name, or cannot be opened
std::unique_ptr<Link> open_link(const std::string& name);

}  // namespace curvecore::sysc
