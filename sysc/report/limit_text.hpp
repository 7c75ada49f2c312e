// SPDX-License-Identifier: Apache-2.0
// Measured limits, and how far a tool that swings is off the path, as text: report.json,
// report.html, the table and the checks.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/job/job.hpp"
#include "sysc/watch/check_result.hpp"
#include "sysc/watch/limit_meter.hpp"
#include "sysc/watch/tool_meter.hpp"

namespace curvecore::sysc {

/// Worst ratios, their places, and a row per window; null where a window is not resolved.
nlohmann::ordered_json limits_json(const Job& job, const LimitLoads& limits);

/// Worst ratio and its place, in one line.
std::string limits_text(const Job& job, const LimitLoads& limits);

/// Rows [window in ms, path or axis, velocity, acceleration, jerk] of resolved windows.
nlohmann::ordered_json limits_rows(const Job& job, const LimitLoads& limits);

/// The tool's distances, and what the shaped steps ask of the drives.
nlohmann::ordered_json tool_json(const Job& job, const ToolResult& tool);

/// The same in one line.
std::string tool_text(const Job& job, const ToolResult& tool);

/// Planned ratios to the limits.
nlohmann::ordered_json ratios_json(const ref::LimitRatios& ratios);

/// Distance of the tool from its path, of a machine with joints, before rounding.
nlohmann::ordered_json joints_json(const Job& job, const CheckResult& check);
std::string joints_text(const Job& job, const CheckResult& check);

}  // namespace curvecore::sysc
