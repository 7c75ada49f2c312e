// SPDX-License-Identifier: Apache-2.0
// waves.gtkw: GTKWave opens waves.fst with the signals in groups, in the order of the data's flow.
#pragma once

#include <string>

#include "sysc/host/core_parameters.hpp"

namespace curvecore::sysc {

/// The arrangement of `fst_file`; `folder` is where both files will stand.
std::string gtkw(const CoreParameters& core, const std::string& fst_file,
                 const std::string& folder);

}  // namespace curvecore::sysc
