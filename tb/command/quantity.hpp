// SPDX-License-Identifier: Apache-2.0
// Numbers with a unit on the command line.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace curvecore::tb {

/// Name and power of ten.
using Suffix = std::pair<std::string_view, int>;

/// "ns, us, ms or s"
std::string suffix_names(const std::vector<Suffix>& suffixes);

/// A number with one of these units, in the unit's base.
/// @throws UsageError that names `option`: not a finite number, another unit
double quantity(const std::string& option, const std::string& text,
                const std::vector<Suffix>& suffixes);

}  // namespace curvecore::tb
