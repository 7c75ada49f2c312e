// SPDX-License-Identifier: Apache-2.0
// What rtl/motion_board.sv takes with a UART beside its curve core: path, queues, step generators
// of three axes, registers, frames.
#pragma once

#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

/// Whether a board of this build and family was placed.
bool board_cost_is_known(Build build, const Device& device);

/// The whole of a board with this core: what a board took when it was placed
/// (sysc/cost/placed_boards.json), its core's estimate exchanged for this one's; blocks of RAM
/// for queues of 1,024 words, and the clock that was reached. Nothing where no board of this build
/// and family was placed.
std::optional<CostEstimate> board_estimate(Core core, const CoreParameters& parameters,
                                           const Device& device);

}  // namespace curvecore::sysc
