// SPDX-License-Identifier: Apache-2.0
// Which joints of a machine's .ini move which axes.
#pragma once

#include <string>
#include <vector>

#include "ref/machine/ini_file.hpp"

namespace curvecore::sysc {

struct Joint {
    int axis = 0;
    std::string section;
    double unit_mm = 1;  // of lengths; of an angular axis degrees
};

/// In the order of [TRAJ] COORDINATES.
std::vector<Joint> joints_of(const ref::IniFile& ini);

}  // namespace curvecore::sysc
