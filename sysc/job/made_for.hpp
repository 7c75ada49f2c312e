// SPDX-License-Identifier: Apache-2.0
// Settings that words are made for, as the digest at the head of their checks (hls/word_check.hpp):
// a board with other settings accepts none of them.
#pragma once

#include <cstdint>

#include "ref/machine/machine.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct MadeFor {
    std::uint16_t board = 0;  // core, axes, sample period, clock: built into rtl/motion_system.sv
    std::uint16_t host = 0;   // unit, samples per tick, machine: the register DIGEST

    /// Value of digest_i of rtl/motion_interpolator.sv.
    std::uint16_t digest() const { return board ^ host; }
};

MadeFor made_for(const Options& options, const ref::Machine& machine);

}  // namespace curvecore::sysc
