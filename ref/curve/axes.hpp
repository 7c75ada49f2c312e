// SPDX-License-Identifier: Apache-2.0
// The axes of a machine, X Y Z A B C U V W; all but X Y Z are auxiliary.
#pragma once

#include <array>
#include <string_view>

namespace curvecore::ref {

constexpr std::string_view kAxisLetters = "XYZABCUVW";
constexpr std::string_view kAxisNames = "xyzabcuvw";  // of columns, members and parameters
constexpr int kMachineAxes = 9;
using AxisVector = std::array<double, kMachineAxes>;

constexpr int kAuxAxes = 6;  // A B C U V W
using Aux = std::array<double, kAuxAxes>;

}  // namespace curvecore::ref
