// SPDX-License-Identifier: Apache-2.0
// The parameters of a kernel's configuration, by their names in ref/format/parameters.def.
#pragma once

#include "hls/configuration.hpp"

namespace curvecore::tb {

template <class C>
ref::CoreParameters parameters_of() {
    ref::CoreParameters core;
    core.order = C::kOrder;
    core.coef_bits = C::kCoefBits;
    core.position_bits = C::kPositionBits;
    core.guard_bits = C::kGuardBits;
    core.mode = static_cast<int>(C::kMode);
    core.parameter_guard = C::kParameterGuard;
    core.aux_axes = C::kAuxAxes;
    core.anchor = C::kAnchor ? 1 : 0;
    return core;
}

}  // namespace curvecore::tb
