// SPDX-License-Identifier: Apache-2.0
// What a mistyped name may have meant.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

/// "did you mean 'run'?" when one of the names differs in up to two letters and in less than half
/// of the word's, whatever their case; else `otherwise`.
std::string nearest_text(const std::string& word, const std::vector<std::string>& names,
                         const std::string& otherwise);

/// "there are run, plan": what to say of a few names.
std::string names_text(const std::vector<std::string>& names);

}  // namespace curvecore::sysc
