// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/board_cost.hpp"

#include <algorithm>

namespace curvecore::sysc {
namespace {

/// A board as `scripts/synth.sh --board` placed it: the table of scripts/README.md. Its core has
/// the parameters that motion_board has where nothing is said.
struct PlacedBoard {
    std::string_view device;
    Build build;
    double lut4;
    double ff;
    int dsp;
    int ram;
    double mhz;
};
constexpr std::array<PlacedBoard, 3> kPlaced{{
    {"ecp5-25", Build::kSerial, 6876, 5166, 4, 24, 67},      // colorlight_i5
    {"gw2a-18", Build::kSerial, 8749, 6134, 4, 19, 67},      // tang_nano_20k
    {"ecp5-85", Build::kParallel, 28434, 20149, 52, 15, 63}  // ulx3s_85
}};

CoreParameters core_of_boards(Build build, const Device& device) {
    CoreParameters core;
    core.build = build;
    core.order = 6;
    core.coef_bits = 36;
    core.position_bits = 32;
    core.guard_bits = 10;
    core.splines = 1;
    core.mode = 1;
    core.sample_interval = 8;
    core.multiplier_form = device.form;
    return core;
}

/// Null: none.
const PlacedBoard* placed_board(Build build, const Device& device) {
    const auto* const found =
        std::find_if(kPlaced.begin(), kPlaced.end(), [&](const PlacedBoard& board) {
            return board.build == build &&
                   device_of(std::string(board.device))->family == device.family;
        });
    return found == kPlaced.end() ? nullptr : found;
}

}  // namespace

bool board_cost_is_known(Build build, const Device& device) {
    return placed_board(build, device) != nullptr;
}

std::optional<CostEstimate> board_estimate(Core core, const CoreParameters& parameters,
                                           const Device& device) {
    const PlacedBoard* const placed = placed_board(parameters.build, device);
    std::optional<CostEstimate> cost = estimate(core, parameters, device);
    if (placed == nullptr || !cost) return std::nullopt;
    const CostEstimate theirs =
        *estimate(Core::kCurve, core_of_boards(placed->build, device), device);
    cost->lut4 += placed->lut4 - theirs.lut4;
    cost->ff += placed->ff - theirs.ff;
    cost->dsp += placed->dsp - theirs.dsp;
    cost->ram += placed->ram - theirs.ram;
    cost->mhz = std::min(cost->mhz, placed->mhz);
    return cost;
}

}  // namespace curvecore::sysc
