// SPDX-License-Identifier: Apache-2.0
#include "sysc/home/joints.hpp"

#include <fmt/format.h>

#include <cctype>

#include "ref/curve/axes.hpp"

namespace curvecore::sysc {

std::vector<Joint> joints_of(const ref::IniFile& ini) {
    const double unit = ref::mm_per_unit(ini);
    const auto entry = ini.find("TRAJ", "COORDINATES");
    const std::string letters = entry ? entry->value : std::string(ref::kAxisLetters);
    std::vector<Joint> joints;
    for (const char c : letters) {
        const auto axis = ref::kAxisLetters.find(static_cast<char>(std::toupper(c)));
        if (axis == std::string_view::npos) continue;
        const bool angle = axis >= 3 && axis < 6;
        joints.push_back(
            {static_cast<int>(axis), fmt::format("JOINT_{}", joints.size()), angle ? 1 : unit});
    }
    return joints;
}

}  // namespace curvecore::sysc
