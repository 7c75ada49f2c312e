// SPDX-License-Identifier: Apache-2.0
// The FPGAs that scripts/synth.sh places for, and what they hold.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace curvecore::tb {

/// | field     | meaning                                                                       |
/// |-----------|-------------------------------------------------------------------------------|
/// | name      | as scripts/synth.sh has it                                                    |
/// | family    | what the cost model distinguishes                                             |
/// | form      | MultiplierForm that the device's multipliers want                             |
/// | lut4, ff  | what it has of them                                                           |
/// | dsp       | multipliers, 18 x 18 bits (UP5K: 16 x 16)                                     |
/// | ram       | block memories                                                                |
/// | dsp_mhz   | limit of a DSP block, where place and route does not time it; 0: none known   |
///
/// scripts/synthesis/devices.py has the same numbers; tb/cli/device_test.cpp holds them equal.
struct Device {
    std::string_view name;
    std::string_view family;
    int form;
    int lut4;
    int ff;
    int dsp;
    int ram;
    double dsp_mhz;
};

constexpr std::array<Device, 7> kDevices{{
    {"up5k", "up5k", 2, 5280, 5280, 8, 30, 110},
    {"hx8k", "hx8k", 0, 7680, 7680, 0, 32, 0},
    {"ecp5-25", "ecp5", 1, 24288, 24288, 28, 56, 294},
    {"ecp5-45", "ecp5", 1, 43848, 43848, 72, 108, 294},
    {"ecp5-85", "ecp5", 1, 83640, 83640, 156, 208, 294},
    {"gw2a-18", "gw2a-18", 0, 20736, 15552, 48, 46, 0},
    {"lifcl-40", "lifcl-40", 0, 32256, 32256, 56, 84, 0},
}};

/// @throws UsageError that lists them: there is none of this name
const Device* device_of(const std::string& name);

}  // namespace curvecore::tb
