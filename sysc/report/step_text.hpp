// SPDX-License-Identifier: Apache-2.0
// Results of a board's step pins, for reports.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sysc/board/board.hpp"

namespace curvecore::sysc {

/// Returns true if no step was lost, dropped or refused.
bool every_step_given(const StepStatus& steps);

/// Returns the results; `axes` are their names.
nlohmann::ordered_json steps_json(const StepStatus& steps, const std::vector<std::string>& axes);
std::string steps_text(const StepStatus& steps, const std::vector<std::string>& axes);
std::string following_error_text(const StepStatus& steps, const std::vector<std::string>& axes);

}  // namespace curvecore::sysc
