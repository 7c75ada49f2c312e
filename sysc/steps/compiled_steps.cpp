// SPDX-License-Identifier: Apache-2.0
// A Verilated step generator as a block: compiled once for each model.
#include CFG_HEADER
#include CFG_BLOCK_HEADER

namespace curvecore::sysc {

StepBlock* CFG_FUNCTION(const StepSetup& setup) {
    return new CFG_BLOCK<CFG_MODEL>(setup, CFG_Axes);
}

}  // namespace curvecore::sysc
