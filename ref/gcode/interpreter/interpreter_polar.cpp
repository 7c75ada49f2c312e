// SPDX-License-Identifier: Apache-2.0
// The polar words @ and ^: X and Y by their distance from the program's zero and their angle there.
// A missing one is that of the present place; in G91 they are added to it.
#include <fmt/format.h>

#include <cmath>

#include "ref/gcode/interpreter/interpreter.hpp"
#include "ref/numeric/angles.hpp"

namespace curvecore::ref {

void Interpreter::resolve_polar(Block& block, const Codes& codes, const Place& place) const {
    if (!block.polar_radius && !block.polar_angle) return;
    if (block.has_any("XY")) place.refuse("polar coordinates (@ ^) beside X or Y");
    if (block.has('L')) place.refuse("polar coordinates (@ ^) do not repeat (L): give each place");
    if (const std::optional<int> action = codes.of(Group::kAction)) {
        place.refuse(
            fmt::format("polar coordinates (@ ^) are of motion, not of {}", g_name(*action)));
    }
    const double x = coordinates_.programmed(0);
    const double y = coordinates_.programmed(1);
    const bool relative = !coordinates_.absolute();
    if (x == 0 && y == 0 && (relative || !block.polar_angle)) {
        place.refuse("polar coordinates want the angle (^) in G90: the program's zero has none");
    }
    double radius = std::hypot(x, y);
    double angle = std::atan2(y, x);
    if (relative) {
        radius += block.polar_radius.value_or(0);
        angle += block.polar_angle.value_or(0) * kRadiansPerDegree;
    } else {
        radius = block.polar_radius.value_or(radius);
        if (block.polar_angle) angle = *block.polar_angle * kRadiansPerDegree;
    }
    block.give('X', radius * std::cos(angle) - (relative ? x : 0));
    block.give('Y', radius * std::sin(angle) - (relative ? y : 0));
}

}  // namespace curvecore::ref
