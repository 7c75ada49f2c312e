// SPDX-License-Identifier: Apache-2.0
// The pins of a Verilated motion_board of three axes, clock by clock.
#pragma once

#include <cstdint>

namespace curvecore::sysc {

class VirtualModel {
  public:
    struct Inputs {
        bool byte_valid = false;
        std::uint8_t byte = 0;
        unsigned home = 0;  // a bit an axis
        unsigned limit = 0;
        unsigned encoder_a = 0;
        unsigned encoder_b = 0;
    };
    struct Outputs {
        bool byte_ready = false;
        bool byte_valid = false;
        std::uint8_t byte = 0;
        bool enable = false;
        unsigned step = 0;
        unsigned direction = 0;
        unsigned outputs = 0;  // PWM is bit 8
    };

    virtual ~VirtualModel() = default;
    virtual void reset() = 0;
    /// Advances by one clock with these inputs; the outputs follow.
    virtual void tick() = 0;

    Inputs in;
    Outputs out;
    std::uint64_t clocks = 0;
};

/// Function that sysc/virtual/compiled_board.cpp makes of one model; the caller owns it.
using MakeVirtualModel = VirtualModel*();

}  // namespace curvecore::sysc
