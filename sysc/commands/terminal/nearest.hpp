// SPDX-License-Identifier: Apache-2.0
// Suggestions for a mistyped name.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// Returns "did you mean 'run'?" when one of the names differs, ignoring case, in up to two letters
/// and in less than half of the word's; otherwise `otherwise`.
std::string nearest_text(const std::string& word, const std::vector<std::string>& names,
                         const std::string& otherwise);

/// Lists a few names: "there are run, plan".
std::string names_text(const std::vector<std::string>& names);

}  // namespace curvecore::sysc
