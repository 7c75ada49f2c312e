// SPDX-License-Identifier: Apache-2.0
// A system in SystemC as a board: the host's port, a bus that takes time, and a board whose timer
// asks a core for a sample each period. SystemC's headers stay in systemc_board.cpp.
#pragma once

#include <memory>

#include "sysc/board/board.hpp"

namespace curvecore::sysc {

struct SystemTimes {
    double sample_s = 100e-6;  // from sample to sample
    double word_s = 1e-6;      // of a word of 48 bits on the bus
    double host_s = 1e-3;      // from one look of the host to the next
    double clock_s = 0.01e-6;  // the core's clock
};

/// `core` is a board without a timer of its own: the kernel or a Verilated core. There is one
/// SystemC simulation in a process, and so one such board.
std::unique_ptr<Board> make_systemc_board(std::unique_ptr<Board> core, const SystemTimes& times);

}  // namespace curvecore::sysc
