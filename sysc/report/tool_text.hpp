// SPDX-License-Identifier: Apache-2.0
// The tool behind drives that swing, as text: report.json and the table.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/job/job.hpp"
#include "sysc/watch/tool_meter.hpp"

namespace curvecore::sysc {

/// How far it is off the path, and what the shaped steps ask of the drives.
nlohmann::ordered_json tool_json(const Job& job, const ToolResult& tool);

/// The same in one line.
std::string tool_text(const Job& job, const ToolResult& tool);

}  // namespace curvecore::sysc
