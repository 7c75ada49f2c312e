// SPDX-License-Identifier: Apache-2.0
// The configuration of a test that CFG_... macros name (tb/configurations.cmake).
#pragma once

#include "hls/configuration.hpp"

#ifndef CFG_MultiplierForm
#define CFG_MultiplierForm 0
#endif

#ifndef CFG_Splines
#define CFG_Splines 0
#endif

#ifndef CFG_SampleInterval
#define CFG_SampleInterval 1
#endif

#ifndef CFG_TurnBits
#define CFG_TurnBits 0
#endif

#ifndef CFG_ParameterGuard
#define CFG_ParameterGuard 0
#endif

#ifndef CFG_Anchor
#define CFG_Anchor 1
#endif

namespace curvecore::sysc {

using Config = hls::Configuration<CFG_Order, CFG_CoefBits, CFG_PositionBits, CFG_GuardBits,
                                  CFG_AuxAxes, static_cast<hls::SamplerMode>(CFG_Mode),
                                  CFG_Anchor != 0, CFG_TurnBits, CFG_ParameterGuard>;
constexpr bool kPortable = CFG_MultiplierForm == 0;  // models of DSP primitives simulate slowly
constexpr int kAxes = Config::kAxes;
constexpr int kFineBits = Config::kFineBits;
constexpr int kPositionBits = Config::kPositionBits;

}  // namespace curvecore::sysc
