// SPDX-License-Identifier: Apache-2.0
// The two tables of devices, of tb/compare and of scripts/synthesis, have the same numbers.
#include "tb/compare/device.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/cli/program_run.hpp"

namespace curvecore::tb {
namespace {

using Json = nlohmann::json;

const char* const kPrint = R"(
import json, sys
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
from synthesis.devices import DEVICES
print(json.dumps({name: {"form": device.family.form, "dsp_mhz": device.dsp_limit or 0,
                         **device.available} for name, device in DEVICES.items()}))
)";

TEST(Devices, AreThoseOfSynth) {
    const ProgramResult printed =
        ProgramRun("/usr/bin/env").run({SYNTH_PYTHON, "-c", kPrint, SYNTH_FOLDER});
    ASSERT_EQ(printed.status, 0) << printed.err;
    Json here = Json::object();
    for (const Device& device : kDevices) {
        here[std::string(device.name)] = {{"form", device.form}, {"dsp_mhz", device.dsp_mhz},
                                          {"lut4", device.lut4}, {"ff", device.ff},
                                          {"dsp", device.dsp},   {"bram", device.ram}};
    }
    EXPECT_EQ(here, Json::parse(printed.out));
}

}  // namespace
}  // namespace curvecore::tb
