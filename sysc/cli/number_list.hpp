// SPDX-License-Identifier: Apache-2.0
// Lists and ranges of whole numbers on the command line.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// "6", "4,6,8", "24:36:4" (first:last:step, step 1 when left out), and lists of these; each number
/// once, in the order given.
/// @throws UsageError that names `option`: empty, not a number, a range that runs backwards, a
///         number beyond low .. high
std::vector<int> number_list(const std::string& option, const std::string& text, int low, int high);

}  // namespace curvecore::sysc
