// SPDX-License-Identifier: Apache-2.0
// Random pauses on a handshake, short ones often and long ones now and then.
#pragma once

#include <cstdint>
#include <optional>

namespace curvecore::sysc {

class Staller {
  public:
    /// Creates a staller; without a seed it never stalls. Handshakes with different streams stall
    /// independently.
    Staller(std::optional<std::uint64_t> seed, std::uint64_t stream)
        : on_(seed.has_value()),
          state_((seed.value_or(0) + 1) * 0x9E3779B97F4A7C15u + stream * 0xD1B54A32D192ED03u) {}

    /// Returns true if the handshake may go on in this clock.
    bool go() {
        if (!on_) return true;
        if (pause_ > 0) {
            --pause_;
            return false;
        }
        const std::uint64_t draw = next();
        if (draw % 256 == 0) pause_ = static_cast<int>((draw >> 8) % 300);
        return (draw >> 40) % 4 != 0;
    }

  private:
    /// The generator splitmix64.
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    bool on_;
    std::uint64_t state_;
    int pause_ = 0;
};

}  // namespace curvecore::sysc
