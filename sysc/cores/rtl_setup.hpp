// SPDX-License-Identifier: Apache-2.0
// Settings with which a Verilated core becomes a board.
#pragma once

#include <optional>
#include <string>

#include "sysc/board/board.hpp"

namespace curvecore::sysc {

struct RtlSetup {
    BoardSettings settings;
    std::optional<std::uint64_t> stall_seed;  // random pauses on every handshake
    std::string waveform;                     // file; empty: none
    std::uint64_t trace_clocks = 0;
    double clock_hz = 0;  // clock of the waveform
};

/// Function that sysc/cores/compiled_core.cpp makes of one model; the caller owns the board.
using MakeBoard = Board*(const RtlSetup& setup);

}  // namespace curvecore::sysc
