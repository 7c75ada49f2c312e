// SPDX-License-Identifier: Apache-2.0
// The kernel that draws a table's curve (ref/curves/curve_table.hpp), as text of C++: a class over
// hls/curves/curve_steps.hpp with one statement a line of the table, which stands above it.
#pragma once

#include <string>

#include "ref/curves/curve_table.hpp"

namespace curvecore {
namespace hls {

/// The header's text. `remarks` is the table's text with its remarks.
/// @throws ref::InputError for a line that has no such statement, with file and line
std::string kernel_text(const ref::CurveTable& table, const std::string& remarks);

/// The class of the kernel: arc, of arc.net, is ArcCurve.
std::string kernel_class(const ref::CurveTable& table);

}  // namespace hls
}  // namespace curvecore
