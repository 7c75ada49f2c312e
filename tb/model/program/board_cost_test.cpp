// SPDX-License-Identifier: Apache-2.0
// Cost of a whole board, compared with the boards that were placed.
#include "sysc/cost/board_cost.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "sysc/core/board_file.hpp"

namespace curvecore::sysc::board_cost_test {

nlohmann::ordered_json placed_boards() {
    std::ifstream file(PLACED_BOARDS);
    return nlohmann::ordered_json::parse(file);
}

TEST(BoardCost, OfAPlacedBoardIsWhatItTook) {
    std::map<std::string, int> seen;  // the first of each build and device represents it
    for (const auto& row : placed_boards()) {
        const Device* const device = find_device(device_of_board(row));
        if (device == nullptr) continue;
        const CoreParameters core = core_of_board(row.at("parameters"));
        const std::string kind = std::string(device->name) + build_name(core.build);
        if (seen[kind]++ > 0) continue;
        const auto cost =
            board_estimate(core_for(true, core.splines == 1, core.build), core, *device);
        ASSERT_TRUE(cost.has_value()) << row.at("board");
        EXPECT_NEAR(cost->lut4, row.at("lut4"), 1e-6) << row.at("board");
        EXPECT_NEAR(cost->ff, row.at("ff"), 1e-6) << row.at("board");
        EXPECT_EQ(cost->dsp, row.at("dsp")) << row.at("board");
        EXPECT_EQ(cost->ram, row.at("bram")) << row.at("board");
        EXPECT_LE(*cost->mhz, row.at("fmax_mhz")) << row.at("board");
    }
    EXPECT_GE(seen.size(), 5U);
}

}  // namespace curvecore::sysc::board_cost_test
