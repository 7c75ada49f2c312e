// SPDX-License-Identifier: Apache-2.0
// The exact part of the cost model.
#pragma once

#include "tb/compare/cost_model.hpp"

namespace curvecore::tb {

int count_dsp(Core core, const CoreParameters& parameters, const Device& device);
int count_ram(Core core, const CoreParameters& parameters, const Device& device);

}  // namespace curvecore::tb
