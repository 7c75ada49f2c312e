// SPDX-License-Identifier: Apache-2.0
// Whether a program begins where the machine stands.
#pragma once

#include <array>
#include <string>

#include "sysc/board/board.hpp"
#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

/// Axes of which it is not known where they stand are taken to stand where the program begins; but
/// those that have a home switch in the machine's file must be homed. `start` in mm.
/// @throws UsageError, ref::InputError of the machine's file
void check_start(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                 const Drives& drives, const std::string& machine_file);

}  // namespace curvecore::sysc
