// SPDX-License-Identifier: Apache-2.0
// What a machine has before its program begins: tools, stored positions and offsets.
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
/// | arc_tolerance | mm     | by how much radii may differ; none: as ArcTolerance says    |
struct ProgramStart {
    ToolTable tools;
    std::map<int, double> parameters;
    double unit = 1;
    std::optional<double> arc_tolerance;
};

/// That of LinuxCNC's .ini: TOOL_TABLE of [EMCIO], PARAMETER_FILE of [RS274NGC], files beside it,
/// which need not be there, in its LINEAR_UNITS. @param ini empty: of no machine
/// @param tools a tool table instead of the .ini's, which is there; empty: none
/// @throws InputError
ProgramStart read_program_start(const std::string& ini, const std::string& tools);

}  // namespace curvecore::ref
