// SPDX-License-Identifier: Apache-2.0
// What a board's step pins did, for reports.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sysc/board/board.hpp"

namespace curvecore::sysc {

/// No step lost, dropped or refused.
bool every_step_given(const StepStatus& steps);

/// `axes`: their names.
nlohmann::ordered_json steps_json(const StepStatus& steps, const std::vector<std::string>& axes);
std::string steps_text(const StepStatus& steps, const std::vector<std::string>& axes);
std::string following_error_text(const StepStatus& steps, const std::vector<std::string>& axes);

}  // namespace curvecore::sysc
