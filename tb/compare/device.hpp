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
/// | lut4      | of as many flip-flops                                                         |
/// | dsp       | multipliers, 18 x 18 (ECP5) or 16 x 16 bits (UP5K)                            |
/// | ram       | block memories                                                                |
/// | dsp_mhz   | limit of a DSP block, which place and route does not time; 0: there are none  |
struct Device {
    std::string_view name;
    std::string_view family;
    int form;
    int lut4;
    int dsp;
    int ram;
    double dsp_mhz;
};

constexpr std::array<Device, 5> kDevices{{
    {"up5k", "up5k", 2, 5280, 8, 30, 110},
    {"hx8k", "hx8k", 0, 7680, 0, 32, 0},
    {"ecp5-25", "ecp5", 1, 24288, 28, 56, 294},
    {"ecp5-45", "ecp5", 1, 43848, 72, 108, 294},
    {"ecp5-85", "ecp5", 1, 83640, 156, 208, 294},
}};

/// @throws UsageError that lists them: there is none of this name
const Device* device_of(const std::string& name);

}  // namespace curvecore::tb
