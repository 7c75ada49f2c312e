// SPDX-License-Identifier: Apache-2.0
// What the machine can do, in mm, s (degrees for rotary axes). LinuxCNC's names, in its .ini file.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace curvecore::ref {

constexpr int kMachineAxes = 9;  // X Y Z A B C U V W

struct AxisLimits {
    double velocity = 500;       // mm/s
    double acceleration = 5000;  // mm/s^2
    double jerk = 100000;        // mm/s^3
    double min = -1000;          // mm
    double max = 1000;           // mm
};

struct Machine {
    std::string name = "built-in";
    double velocity = 500;       // along the path
    double acceleration = 5000;  // along and across the path
    double jerk = 100000;
    double joint_time = 1e-3;  // s: how long a joint's change of velocity or acceleration may take
    std::array<AxisLimits, kMachineAxes> axis;
    std::vector<std::string> notes;  // defaults that were taken, for the report
};

/// Reads LinuxCNC's .ini: [TRAJ] MAX_LINEAR_VELOCITY .., [AXIS_X] / [JOINT_n] MAX_VELOCITY .., LINEAR_UNITS.
/// @throws ref::InputError with FILE:LINE and the reason.
Machine read_machine(const std::string& file);

}  // namespace curvecore::ref
