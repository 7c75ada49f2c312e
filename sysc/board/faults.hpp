// SPDX-License-Identifier: Apache-2.0
// Faults: the bits of fault_o of rtl/motion_interpolator.sv and their texts.
#pragma once

#include <string>

namespace curvecore::sysc {

enum Fault {
    kSegmentWord,
    kSegmentOrder,
    kPieceWord,
    kPieceOrder,
    kApart,
    kShortQueue,
    kSettings,
    kNoSample,
    kFaults
};

inline std::string fault_text(unsigned fault) {
    const char* const causes[kFaults] = {
        "a segment word that cannot be, is not as it was made or for another configuration",
        "a segment missing, doubled or not from the last end",
        "a profile word that cannot be, is not as it was made or for another configuration",
        "a piece missing or doubled",
        "segments and pieces end apart",
        "a full queue does not cover a stop",
        "settings that cannot be, or that changed in motion",
        "no sample for too long"};
    std::string text;
    for (const char* cause : causes) {
        if ((fault & 1) != 0) text += (text.empty() ? "" : ", ") + std::string(cause);
        fault >>= 1;
    }
    return text.empty() ? "none" : text;
}

}  // namespace curvecore::sysc
