// SPDX-License-Identifier: Apache-2.0
#include "sysc/cores/waveform_signals.hpp"

#include <gtkwave/fstapi.h>

namespace curvecore::sysc {

WaveformSignals waveform_signals(const std::string& fst_file) {
    WaveformSignals signals;
    void* reader = fstReaderOpen(fst_file.c_str());
    if (reader == nullptr) return signals;
    while (const fstHier* item = fstReaderIterateHier(reader)) {
        if (item->htyp == FST_HT_SCOPE) {
            fstReaderPushScope(reader, item->u.scope.name, nullptr);
        } else if (item->htyp == FST_HT_UPSCOPE) {
            fstReaderPopScope(reader);
        } else if (item->htyp == FST_HT_VAR) {
            // Verilator writes "name [31:0]".
            const std::string name = item->u.var.name;
            const std::size_t space = name.find(' ');
            const std::string scope = fstReaderGetCurrentFlatScope(reader);
            signals[scope + "." + name.substr(0, space)] =
                space == std::string::npos ? "" : name.substr(space + 1);
        }
    }
    fstReaderClose(reader);
    return signals;
}

}  // namespace curvecore::sysc
