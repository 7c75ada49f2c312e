// SPDX-License-Identifier: Apache-2.0
#include "sysc/cost/board_cost.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "sysc/core/board_file.hpp"
#include "sysc/cost/placed_boards_data.hpp"

namespace curvecore::sysc {
namespace {

/// A row of sysc/cost/placed_boards.json on a device of the table.
struct PlacedBoard {
    const Device* device;
    CoreParameters core;
    double lut4;
    double ff;
    int dsp;
    int ram;
    double mhz;
};

std::vector<PlacedBoard> placed_boards() {
    std::vector<PlacedBoard> placed;
    for (const auto& row : nlohmann::ordered_json::parse(kPlacedBoards)) {
        const Device* const device = find_device(device_of_board(row));
        if (device == nullptr) continue;
        placed.push_back({device, core_of_board(row.at("parameters")), row.at("lut4"), row.at("ff"),
                          row.at("dsp"), row.at("bram"), row.at("fmax_mhz")});
    }
    return placed;
}

/// Finds a placed board of this build with this device, or with one of its family; null: none.
const PlacedBoard* placed_board(Build build, const Device& device) {
    static const std::vector<PlacedBoard> kPlaced = placed_boards();
    const PlacedBoard* of_family = nullptr;
    for (const PlacedBoard& board : kPlaced) {
        if (board.core.build != build) continue;
        if (board.device == &device) return &board;
        if (of_family == nullptr && board.device->family == device.family) of_family = &board;
    }
    return of_family;
}

/// The cost of the engine's board, which has the same circuits for words of any width; its store is
/// of the placed configuration.
std::optional<CostEstimate> engine_board(const PlacedBoard& placed, const CoreParameters& asked) {
    if (asked.order > placed.core.order || asked.splines > placed.core.splines ||
        asked.aux_axes > placed.core.aux_axes) {
        return std::nullopt;
    }
    CostEstimate cost;
    cost.lut4 = placed.lut4;
    cost.ff = placed.ff;
    cost.dsp = placed.dsp;
    cost.ram = placed.ram;
    cost.mhz = placed.mhz;
    return cost;
}

}  // namespace

bool board_cost_is_known(Build build, const Device& device) {
    return placed_board(build, device) != nullptr &&
           (build == Build::kEngine || cost_is_known(build, device));
}

std::optional<CostEstimate> board_estimate(Core core, const CoreParameters& parameters,
                                           const Device& device) {
    const PlacedBoard* const placed = placed_board(parameters.build, device);
    if (placed != nullptr && parameters.build == Build::kEngine) {
        return engine_board(*placed, parameters);
    }
    std::optional<CostEstimate> cost = estimate(core, parameters, device);
    if (placed == nullptr || !cost) return std::nullopt;
    const Core drawn = core_for(true, placed->core.splines == 1, placed->core.build);
    const CostEstimate theirs = *estimate(drawn, placed->core, device);
    cost->lut4 += placed->lut4 - theirs.lut4;
    cost->ff += placed->ff - theirs.ff;
    cost->dsp += placed->dsp - theirs.dsp;
    cost->ram += placed->ram - theirs.ram;
    cost->mhz = std::min(cost->mhz.value_or(placed->mhz), placed->mhz);
    return cost;
}

}  // namespace curvecore::sysc
