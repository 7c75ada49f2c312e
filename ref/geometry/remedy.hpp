// SPDX-License-Identifier: Apache-2.0
// Advice for a move that the words of a configuration cannot carry.
#pragma once

#include <functional>
#include <string>

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// Returns "needs CoefBits 36" and the like: the least change that `fits` accepts.
std::string remedy(const PlanOptions& options,
                   const std::function<bool(const CoreParameters& format, double unit_mm)>& fits);

}  // namespace curvecore::ref
