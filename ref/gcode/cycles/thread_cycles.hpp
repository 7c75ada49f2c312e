// SPDX-License-Identifier: Apache-2.0
// Threads: G33 (a line), G33.1 (a tap, there and back) and G76 (a turned thread in passes), in
// steps, as LinuxCNC executes them: a pitch of path for each turn of the spindle.
#pragma once

#include "ref/gcode/cycles/cycle_step.hpp"
#include "ref/gcode/state/modes.hpp"

namespace curvecore::ref {

inline bool is_thread(int g_code) { return g_code == 330 || g_code == 331 || g_code == 760; }

/// @throws InputError before anything is executed
void carry_out_thread(int g_code, Block& block, const Coordinates& coordinates, const Modes& modes,
                      const Place& place, const CarryOut& carry_out);

}  // namespace curvecore::ref
