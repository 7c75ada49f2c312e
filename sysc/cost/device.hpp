// SPDX-License-Identifier: Apache-2.0
// The FPGAs of the table sysc/cost/devices.def.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace curvecore::sysc {

/// A row of the table; the table describes its fields.
struct Device {
    std::string_view name;
    std::string_view family;
    int form;
    int lut4;
    int ff;
    int dsp;
    int ram;
    double dsp_mhz;

    std::string_view lut_name() const { return family == "xc7" ? "LUT6" : "LUT4"; }
};

inline constexpr std::array kDevices{
#define DEVICE(name, family, ...) Device{#name, #family, __VA_ARGS__},
#include "sysc/cost/devices.def"
};

/// Names as text: "up5k, hx8k, ...".
std::string device_names();

/// Error text for a device that nothing is placed for.
std::string clock_unknown(const Device& device);

/// Finds a device by its name; null: none.
const Device* find_device(const std::string& name);
/// Returns the device of this name. @throws UsageError that lists the names if there is none
const Device* device_of(const std::string& name);

}  // namespace curvecore::sysc
