// SPDX-License-Identifier: Apache-2.0
// Cost of rtl/motion_board.sv with a UART, beside its curve core: path, queues, step generators of
// three axes, registers, frames.
#pragma once

#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

/// Returns true if a board of this build and family was placed.
bool board_cost_is_known(Build build, const Device& device);

/// Estimates a whole board with this core: the cost of a placed board with this device, or else one
/// of its family (sysc/cost/placed_boards.json), with its core's estimate replaced by this one's,
/// blocks of RAM for queues of 1,024 words, and the clock that was reached; of the engine the cost
/// of the placed board. None where no board of this build and family was placed.
std::optional<CostEstimate> board_estimate(Core core, const CoreParameters& parameters,
                                           const Device& device);

}  // namespace curvecore::sysc
