// SPDX-License-Identifier: Apache-2.0
// The file segments.json: the plan, segment by segment, with the words that the core receives.
#pragma once

#include <functional>
#include <string>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// Writes the plan; `write` receives the text, a segment at a time.
void write_segments(const Job& job, const std::function<void(const std::string& text)>& write);

}  // namespace curvecore::sysc
