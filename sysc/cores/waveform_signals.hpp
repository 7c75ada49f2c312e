// SPDX-License-Identifier: Apache-2.0
// The signals of a waveform file.
#pragma once

#include <map>
#include <string>

namespace curvecore::sysc {

/// Full name -> its range, "[31:0]" or nothing.
using WaveformSignals = std::map<std::string, std::string>;

WaveformSignals waveform_signals(const std::string& fst_file);

}  // namespace curvecore::sysc
