// SPDX-License-Identifier: Apache-2.0
// The devices of the table as an error lists them.
#pragma once

#include <string>

#include "sysc/cost/device.hpp"

namespace curvecore::tb {

/// "up5k, hx8k, ..."
inline std::string device_list() {
    std::string names;
    for (const sysc::Device& device : sysc::kDevices) {
        names.append(names.empty() ? "" : ", ").append(device.name);
    }
    return names;
}

}  // namespace curvecore::tb
