// SPDX-License-Identifier: Apache-2.0
// The cost model against the runs it was fitted to: DSP and RAM exactly, the rest as the fitting
// script predicts.
#include "sysc/cost/cost_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sysc/cost/cost_structure.hpp"

namespace curvecore::tb::cost_model_test {
using namespace sysc;

using Json = nlohmann::json;

struct KnownRun {
    Core core;
    CoreParameters parameters;
    const Device* device;
    Json json;
};

std::vector<KnownRun> runs() {
    std::ifstream file(COST_MODEL);
    const Json model = Json::parse(file);
    std::vector<KnownRun> all;
    for (const Json& one : model.at("runs")) {
        KnownRun run;
        const std::string core = one.at("core");
        run.core = core == "spherical" ? Core::kSpherical
                   : core == "spline"  ? Core::kSpline
                                       : Core::kCurve;
        CoreParameters& p = run.parameters;
        p.build = one.at("build") == "serial" ? Build::kSerial : Build::kParallel;
        p.splines = run.core == Core::kSpherical ? 0 : 1;
        for (const char* name : {"Order", "CoefBits", "PositionBits", "GuardBits", "AuxAxes",
                                 "Mode", "SampleInterval"}) {
            single_parameter(std::string(name) + "=" + std::to_string(one.at(name).get<int>()))
                .set(p);
        }
        run.device = std::find_if(kDevices.begin(), kDevices.end(), [&](const Device& device) {
            return device.name == one.at("device").get<std::string>();
        });
        if (run.device == kDevices.end()) continue;
        run.json = one;
        all.push_back(run);
    }
    return all;
}

TEST(CostModel, CountsDspAndRamExactly) {
    for (const KnownRun& run : runs()) {
        const auto cost = estimate(run.core, run.parameters, *run.device);
        ASSERT_TRUE(cost) << run.json;
        EXPECT_EQ(cost->dsp, run.json.at("dsp")) << run.json;
        EXPECT_EQ(cost->ram, run.json.at("bram")) << run.json;
    }
}

/// Blocks that Yosys made of rtl/multiplier/multiplier.sv alone, of these widths.
TEST(CostModel, CountsTheBlocksOfThePortableMultiplier) {
    struct Made {
        const char* device;
        int bits;
        int dsp;
    };
    for (const Made& made :
         {Made{"gw2a-18", 18, 1}, Made{"gw2a-18", 20, 1}, Made{"gw2a-18", 21, 3},
          Made{"gw2a-18", 22, 4}, Made{"gw2a-18", 36, 4}, Made{"lifcl-40", 18, 1},
          Made{"lifcl-40", 19, 4}, Made{"lifcl-40", 35, 4}, Made{"lifcl-40", 36, 6},
          Made{"hx8k", 36, 0}, Made{"xc7a35t", 18, 1}, Made{"xc7a35t", 19, 3},
          Made{"xc7a35t", 22, 3}, Made{"xc7a35t", 23, 4}, Made{"xc7a35t", 35, 4},
          Made{"xc7a35t", 36, 5}}) {
        CoreParameters parameters;
        parameters.build = Build::kSerial;
        parameters.coef_bits = made.bits;
        EXPECT_EQ(count_dsp(Core::kSpherical, parameters, *device_of(made.device)), made.dsp)
            << made.device << ' ' << made.bits;
    }
}

TEST(CostModel, PredictsWhatTheScriptPredicts) {
    EXPECT_GE(runs().size(), 9U);
    for (const KnownRun& run : runs()) {
        const auto cost = estimate(run.core, run.parameters, *run.device);
        const Json& predicted = run.json.at("predicted");
        EXPECT_NEAR(cost->lut4, predicted.at("lut4").get<double>(), 0.01);
        EXPECT_NEAR(cost->ff, predicted.at("ff").get<double>(), 0.01);
        if (!clock_is_known(*run.device)) {
            EXPECT_FALSE(cost->mhz || cost->reached());
            continue;
        }
        const double mhz = 1000 / predicted.at("period_ns").get<double>();
        const double limit = run.device->dsp_mhz;
        EXPECT_NEAR(*cost->mhz, limit > 0 ? std::min(mhz, limit) : mhz, 0.01);
    }
}

TEST(CostModel, IsNearTheRuns) {
    for (const KnownRun& run : runs()) {
        const double most = run.parameters.build == Build::kSerial ? 0.1 : 0.2;
        const auto cost = estimate(run.core, run.parameters, *run.device);
        EXPECT_NEAR(cost->lut4 / run.json.at("lut4").get<double>(), 1, most) << run.json;
        EXPECT_NEAR(cost->ff / run.json.at("ff").get<double>(), 1, most) << run.json;
    }
}

/// Clock estimates of GW2A-18 scatter more than those of all families together.
TEST(CostModel, HasTheErrorOfTheDevicesFamilyWhereThatIsMore) {
    CoreParameters parameters;
    parameters.build = Build::kSerial;
    const auto error = [&](const char* device) {
        return estimate(Core::kSpherical, parameters, *device_of(device))->mhz_error;
    };
    EXPECT_GT(error("gw2a-18"), 1.5 * error("ecp5-25"));
    EXPECT_GE(error("lifcl-40"), error("ecp5-25"));
}

TEST(CostModel, SaysWhenItKnowsNothing) {
    CoreParameters parameters;
    EXPECT_FALSE(
        estimate(Core::kSpherical, parameters, Device{"other", "other", 0, 1000, 1000, 0, 10, 0}));
    EXPECT_TRUE(estimate(Core::kSpherical, parameters, *device_of("ecp5-25")));
    parameters.networks = 0;
    EXPECT_FALSE(estimate(Core::kSpherical, parameters, *device_of("ecp5-25")));
}

TEST(CostModel, SizeIsTheSumOfTheShares) {
    CostEstimate cost;
    cost.lut4 = 2640;
    cost.ff = 1000;
    cost.dsp = 4;
    cost.ram = 15;
    const Device& up5k = *find_device("up5k");
    EXPECT_DOUBLE_EQ(cost.size(up5k), 1.5);
    EXPECT_TRUE(cost.fits(up5k));
    cost.dsp = 9;
    EXPECT_FALSE(cost.fits(up5k));
}

}  // namespace curvecore::tb::cost_model_test
