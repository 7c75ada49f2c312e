// SPDX-License-Identifier: Apache-2.0
// The configuration of an HLS run: CFG_<Name> is a parameter of the cores.
#pragma once

#include "hls/configuration.hpp"

namespace curvecore {
namespace hls {

using TopConfiguration =
    Configuration<CFG_Order, CFG_CoefBits, CFG_PositionBits, CFG_GuardBits, CFG_AuxAxes,
                  SamplerMode(CFG_Mode), CFG_Anchor != 0, CFG_ParameterGuard>;

}  // namespace hls
}  // namespace curvecore
