// SPDX-License-Identifier: Apache-2.0
// The file system.gtkw: GTKWave opens system.vcd (PinTrace) with pins and places axis by axis.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// Writes the file; `folder`: where both files will stand; it shows all of the motion,
/// `duration_s`.
std::string pin_gtkw(const std::string& folder, const std::vector<std::string>& axes,
                     double duration_s);

}  // namespace curvecore::sysc
