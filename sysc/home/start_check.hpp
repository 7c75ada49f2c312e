// SPDX-License-Identifier: Apache-2.0
// Check that a program begins where the machine stands.
#pragma once

#include <array>
#include <string>

#include "sysc/board/board.hpp"
#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

/// Checks the start, mm. An axis of unknown place is assumed to stand where the program begins, but
/// an axis with a home switch in the machine's file must be homed.
/// @throws UsageError, ref::InputError of the machine's file
void check_start(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                 const Drives& drives, const std::string& machine_file);

/// Keeps the start as the place of the axes, for check_rest() of a later host.
void keep_start(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                const Drives& drives);

/// Checks that the rest of a program, which begins at this place, does so where another host left
/// all axes. @throws UsageError
void check_rest(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                const Drives& drives);

}  // namespace curvecore::sysc
