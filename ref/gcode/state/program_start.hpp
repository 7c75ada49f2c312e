// SPDX-License-Identifier: Apache-2.0
// State of a machine before its program begins: tools, stored positions and offsets.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ref/gcode/state/tool_table.hpp"

namespace curvecore::ref {

/// | field         | unit   | remark                                                      |
/// |---------------|--------|-------------------------------------------------------------|
/// | tools         |        |                                                             |
/// | parameters    | `unit` | G28 5161.., G30 5181.., G92 5210.., system 5220, G54 5221.. |
/// | unit          | mm     | of the machine                                              |
/// | arc_tolerance | mm     | largest difference of radii; none: ArcTolerance             |
struct ProgramStart {
    ToolTable tools;
    std::map<int, double> parameters;
    double unit = 1;
    std::optional<double> arc_tolerance;
};

/// Reads the start from LinuxCNC's .ini: TOOL_TABLE of [EMCIO], PARAMETER_FILE of [RS274NGC], files
/// beside it that may be missing, in its LINEAR_UNITS. @param ini empty: no machine
/// @param tools a tool table that exists, instead of the .ini's; empty: none
/// @throws InputError
ProgramStart read_program_start(const std::string& ini, const std::string& tools);

}  // namespace curvecore::ref
