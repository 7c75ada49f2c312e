// SPDX-License-Identifier: Apache-2.0
// Faults of a board in words, as hls/registers/registers.rdl has them.
#pragma once

#include <string>

#include "hls/registers/registers.h"

namespace curvecore::sysc {

/// Lists the faults in a word of STATE.
inline std::string fault_list(std::uint32_t state, const char* between) {
    std::string text;
    for (std::uint32_t fault = 1; fault != 0; fault <<= 1) {
        if ((state & CURVECORE_FAULTS & fault) == 0) continue;
        text += (text.empty() ? "" : between) + std::string(curvecore_fault_text(fault));
    }
    return text;
}

/// Lists the faults of fault_o of rtl/motion_interpolator.sv, which STATE.motion repeats.
inline std::string fault_text(unsigned fault) {
    return fault == 0 ? "none" : fault_list(CURVECORE_PUT(STATE_MOTION, fault), ", ");
}

}  // namespace curvecore::sysc
