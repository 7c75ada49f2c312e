// SPDX-License-Identifier: Apache-2.0
// segments.json: the plan, segment by segment, with the words that the core gets.
#pragma once

#include <string>

#include "sysc/host/job.hpp"

namespace curvecore::sysc {

std::string segments_json(const Job& job);

}  // namespace curvecore::sysc
