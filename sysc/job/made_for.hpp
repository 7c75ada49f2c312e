// SPDX-License-Identifier: Apache-2.0
// What words are made for, as the digest that their checks begin with (hls/word_check.hpp): a board
// of another configuration lets none of them in.
#pragma once

#include <cstdint>

#include "ref/machine/machine.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {

struct MadeFor {
    std::uint16_t board =
        0;  // core, axes, sample period, clock: rtl/motion_system.sv has it built in
    std::uint16_t host = 0;  // unit, samples per tick, machine: its register DIGEST

    /// digest_i of rtl/motion_interpolator.sv
    std::uint16_t digest() const { return board ^ host; }
};

MadeFor made_for(const Options& options, const ref::Machine& machine);

}  // namespace curvecore::sysc
