// SPDX-License-Identifier: Apache-2.0
// A system in SystemC as a board:
//
//   host_port --b_transport--> bus --b_transport--> timed_board --> core
//                                                        +--> machine: steps, drives, axes
//
// It is loosely timed: a word is in its queue when its transport returns, and the host waits for
// the time that the bus took. Idle time is skipped: clocks of the core between samples, clocks of
// the step generator between steps. SystemC's headers stay in this folder.
#pragma once

#include <memory>

#include "sysc/board/board.hpp"
#include "sysc/system/machine.hpp"
#include "sysc/system/queue_guard.hpp"

namespace curvecore::sysc {

/// Makes the machine. @throws UsageError, as Machine does
std::unique_ptr<Machine> make_machine(const Job& job);

/// Makes the board; `core` is a board without a timer of its own: the kernel or a Verilated core. A
/// process has one SystemC simulation, and so one such board at a time. `machine`: null for samples
/// that move nothing. `trace`: file of pins and axes, TRACE.vcd; empty: none. Only the first board
/// of a process can have one.
std::unique_ptr<Board> make_system_board(const Job& job, std::unique_ptr<Board> core,
                                         std::unique_ptr<Machine> machine,
                                         const std::string& trace = "");

}  // namespace curvecore::sysc
