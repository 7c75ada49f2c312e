// SPDX-License-Identifier: Apache-2.0
// The measured limits in words: report.json, report.html and the checks.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/job/job.hpp"
#include "sysc/watch/limit_meter.hpp"

namespace curvecore::sysc {

/// The worst ratios, where they are, and a row per window; null where that is not resolved.
nlohmann::ordered_json limits_json(const Job& job, const LimitLoads& limits);

/// The worst ratio and where it is, in one line.
std::string limits_text(const Job& job, const LimitLoads& limits);

/// [window in ms, of what, velocity, acceleration, jerk], resolved windows alone.
nlohmann::ordered_json limits_rows(const Job& job, const LimitLoads& limits);

}  // namespace curvecore::sysc
