// SPDX-License-Identifier: Apache-2.0
// A Verilated core as a board: compiled once for each model, by curvecore_program().
#include "ref/format/queues.hpp"
#include "sysc/cores/rtl_board.hpp"
#include CFG_HEADER

namespace curvecore::sysc {

static_assert(CFG_SegmentQueueWords == ref::kBoardSegmentWords, "as all boards have it");
static_assert(CFG_ProfileQueueWords == ref::kBoardProfileWords, "as all boards have it");

extern "C" Board* CFG_FUNCTION(const RtlSetup& setup) {
    return new RtlBoard<CFG_MODEL, CFG_Build, 3 + CFG_AuxAxes, CFG_PositionBits, CFG_GuardBits>(
        setup);
}

}  // namespace curvecore::sysc
