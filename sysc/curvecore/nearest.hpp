// SPDX-License-Identifier: Apache-2.0
// What a mistyped name may have meant.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// "did you mean 'run'?" when one of the names differs in up to two letters, else the list of all.
std::string nearest_text(const std::string& word, const std::vector<std::string>& names);

}  // namespace curvecore::sysc
