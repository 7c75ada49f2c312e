// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/joints.hpp"

#include <fmt/format.h>

#include <cctype>

#include "ref/program/coordinates.hpp"

namespace curvecore::sysc {

std::vector<Joint> joints_of(const ref::IniFile& ini) {
    const auto units = ini.find("TRAJ", "LINEAR_UNITS");
    const bool inches = units && units->value[0] == 'i';
    const auto entry = ini.find("TRAJ", "COORDINATES");
    const std::string letters = entry ? entry->value : std::string(ref::kAxisLetters);
    std::vector<Joint> joints;
    for (const char c : letters) {
        const auto axis = ref::kAxisLetters.find(static_cast<char>(std::toupper(c)));
        if (axis == std::string_view::npos) continue;
        const bool angle = axis >= 3 && axis < 6;
        joints.push_back({static_cast<int>(axis), fmt::format("JOINT_{}", joints.size()),
                          inches && !angle ? 25.4 : 1});
    }
    return joints;
}

}  // namespace curvecore::sysc
