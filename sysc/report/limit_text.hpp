// SPDX-License-Identifier: Apache-2.0
// Measured limits as text: report.json, report.html and the checks.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/job/job.hpp"
#include "sysc/watch/limit_meter.hpp"

namespace curvecore::sysc {

/// Worst ratios, their places, and a row per window; null where a window is not resolved.
nlohmann::ordered_json limits_json(const Job& job, const LimitLoads& limits);

/// Worst ratio and its place, in one line.
std::string limits_text(const Job& job, const LimitLoads& limits);

/// Rows [window in ms, path or axis, velocity, acceleration, jerk] of resolved windows.
nlohmann::ordered_json limits_rows(const Job& job, const LimitLoads& limits);

}  // namespace curvecore::sysc
