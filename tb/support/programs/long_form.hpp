// SPDX-License-Identifier: Apache-2.0
// The count of random cases in a test's short and long form.
#pragma once

#include <cstdlib>

namespace curvecore::tb {

/// Cases of a test: few in the short form, all in the long one, which scripts/campaign.sh runs with
/// CURVECORE_LONG in the environment.
inline int cases(int few, int all) { return std::getenv("CURVECORE_LONG") != nullptr ? all : few; }

}  // namespace curvecore::tb
