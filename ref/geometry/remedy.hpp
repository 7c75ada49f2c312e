// SPDX-License-Identifier: Apache-2.0
// What to say of a move that the words of a configuration cannot carry.
#pragma once

#include <functional>
#include <string>

#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// "needs CoefBits 36" and the like: the least change with which `fits` agrees.
std::string remedy(const PlanOptions& options,
                   const std::function<bool(const CoreParameters& format, double unit_mm)>& fits);

}  // namespace curvecore::ref
