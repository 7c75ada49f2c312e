// SPDX-License-Identifier: Apache-2.0
// G-code (RS274/NGC as LinuxCNC reads it, with its whole language, or another dialect) to moves.
//
// G0 G1 G2 G3 G2.4 G3.4 (by way of a point, next block: end point) G4 G5 G5.1 G5.2 G5.3 (splines in
// G17) G7 G8 G10 G17 G18 G19 G20 G21 G28 G28.1 G30 G30.1 G33 G33.1 G38.2..5 (to their ends)
// G40 G41 G42 (of no diameter) G43 G43.1 G43.2 G49 G52 G53 G54..G59.3 G61 G61.1 G64 G65 G73 G74
// G76 G80..G89 G90 G91 G90.1 G91.1 G92..G92.3 G93 G94 G95 (G33 G76 G95 at the programmed speed of
// the spindle) G96 G97 G98 G99, M70..M73, M98, M99, stops, program ends and '%' frames; G80 yields
// to another motion code. Other G codes are refused with file, line and reason, unknown M codes are
// a warning. G61.1 stops at the end of every move; G64 gives moves their tolerance.
#pragma once

#include <string>
#include <string_view>

#include "ref/moves/move.hpp"
#include "ref/program/gcode_options.hpp"

namespace curvecore::ref {

/// @throws InputError
Program read_gcode(const std::string& file, const GcodeOptions& options = {});

/// @throws InputError, with `file_name` as its file
Program read_gcode_text(std::string_view text, const std::string& file_name,
                        const GcodeOptions& options = {});

}  // namespace curvecore::ref
