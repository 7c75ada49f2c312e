// SPDX-License-Identifier: Apache-2.0
// Home switches of a machine and how they are searched: LinuxCNC's names, in its .ini.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// | field  | name in [JOINT_n]              | remark                                            |
/// |--------|--------------------------------|---------------------------------------------------|
/// | search | HOME_SEARCH_VEL, units/s       | its sign is the switch's direction; 0: no switch  |
/// | latch  | HOME_LATCH_VEL                 | same sign: the place is where the switch closes,  |
/// |        |                                | otherwise where it opens                          |
/// | place  | HOME_OFFSET                    | machine coordinate of that place                  |
/// | home   | HOME                           | where the axis goes in the end                    |
/// |        | HOME_SEQUENCE                  | order of the axes; without it Z is the first      |
/// |        | HOME_IGNORE_LIMITS             | the home switch is a limit switch                 |
/// | reach  | 1.25 (MAX_LIMIT - MIN_LIMIT)   | greatest search distance                          |
struct AxisHome {
    int axis = 0;
    double search = 0;  // mm/s
    double latch = 0;
    double place = 0;  // mm
    double home = 0;
    double reach = 0;
    bool ignore_limits = false;
};

/// Reads the axes of a machine that have a home switch, in the order in which they are homed.
/// @throws ref::InputError
std::vector<AxisHome> read_homes(const std::string& machine_file);

}  // namespace curvecore::sysc
