// SPDX-License-Identifier: Apache-2.0
#include "tb/compare/device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tb/command/usage_error.hpp"

namespace curvecore::tb {

const Device* device_of(const std::string& name) {
    const auto* const found =
        std::find_if(kDevices.begin(), kDevices.end(),
                     [&](const Device& device) { return device.name == name; });
    if (found != kDevices.end()) return &*found;
    std::string names;
    for (const Device& device : kDevices) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", device.name);
    }
    throw UsageError(fmt::format("--device '{}': must be one of {}", name, names));
}

}  // namespace curvecore::tb
