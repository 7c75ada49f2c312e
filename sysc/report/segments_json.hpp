// SPDX-License-Identifier: Apache-2.0
// segments.json: the plan, segment by segment, with the words that the core gets.
#pragma once

#include <functional>
#include <string>

#include "sysc/job/job.hpp"

namespace curvecore::sysc {

/// `write` gets the text, a segment at a time.
void write_segments(const Job& job, const std::function<void(const std::string& text)>& write);

}  // namespace curvecore::sysc
