// SPDX-License-Identifier: Apache-2.0
// Signals of a waveform file.
#pragma once

#include <map>
#include <string>

namespace curvecore::sysc {

/// Map from full name to range, "[31:0]" or empty.
using WaveformSignals = std::map<std::string, std::string>;

WaveformSignals waveform_signals(const std::string& fst_file);

}  // namespace curvecore::sysc
