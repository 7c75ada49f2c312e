// SPDX-License-Identifier: Apache-2.0
#include "sysc/cost/device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sysc/cli/choice.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

std::string device_names() {
    std::string names;
    for (const Device& device : kDevices) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", device.name);
    }
    return names;
}

std::string clock_unknown(const Device& device) {
    return fmt::format(
        "--device {}: its cells are counted, nothing is placed for it, so that its clock is not "
        "known: say --clock",
        device.name);
}

const Device* find_device(const std::string& name) {
    const auto* const found =
        std::find_if(kDevices.begin(), kDevices.end(),
                     [&](const Device& device) { return same_name(device.name, name); });
    return found == kDevices.end() ? nullptr : found;
}

const Device* device_of(const std::string& name) {
    if (const Device* const device = find_device(name)) return device;
    throw UsageError(fmt::format("--device '{}': must be one of {}", name, device_names()));
}

}  // namespace curvecore::sysc
