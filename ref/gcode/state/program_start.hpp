// SPDX-License-Identifier: Apache-2.0
// State of a machine before its program begins: tools, stored positions and offsets.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ref/curve/axes.hpp"
#include "ref/gcode/state/tool_table.hpp"

namespace curvecore::ref {

/// | field         | unit   | remark                                                      |
/// |---------------|--------|-------------------------------------------------------------|
/// | tools         |        |                                                             |
/// | parameters    | `unit` | G28 5161.., G30 5181.., G92 5210.., system 5220, G54 5221.. |
/// | unit          | mm     | of the machine                                              |
/// | arc_tolerance | mm     | largest difference of radii; none: ArcTolerance             |
/// | startup       |        | block that is executed before the program                   |
/// | ini           |        | file of that block, in line startup_line                    |
/// | folders       |        | folders of subs' files, behind the program's own            |
/// | ini_numbers   |        | values of `#<_ini[section]name>`, by "[SECTION]NAME"          |
/// | place         | mm     | where the tool is                                           |
/// | tool_length   | mm     | that of the machine's kinematics: G43 takes no other         |
struct ProgramStart {
    ToolTable tools;
    std::map<int, double> parameters;
    double unit = 1;
    std::optional<double> arc_tolerance;
    std::string startup;
    std::string ini;
    int startup_line = 0;
    std::vector<std::string> folders;
    std::map<std::string, double> ini_numbers;
    AxisVector place{};
    std::optional<double> tool_length;
};

/// Reads the start from LinuxCNC's .ini: TOOL_TABLE of [EMCIO], PARAMETER_FILE of [RS274NGC], files
/// beside it that may be missing, in its LINEAR_UNITS; RS274NGC_STARTUP_CODE; the folders of
/// PROGRAM_PREFIX in [DISPLAY] and of SUBROUTINE_PATH. @param ini empty: no machine
/// @param tools a tool table that exists, instead of the .ini's; empty: none
/// @throws InputError
ProgramStart read_program_start(const std::string& ini, const std::string& tools);

}  // namespace curvecore::ref
