// SPDX-License-Identifier: Apache-2.0
// Joints of a machine's .ini and the axes that they move.
#pragma once

#include <string>
#include <vector>

#include "ref/machine/ini_file.hpp"

namespace curvecore::sysc {

struct Joint {
    int axis = 0;
    std::string section;
    double unit_mm = 1;  // mm a unit of length; degrees on an angular axis
};

/// Returns the joints in the order of [TRAJ] COORDINATES.
std::vector<Joint> joints_of(const ref::IniFile& ini);

}  // namespace curvecore::sysc
