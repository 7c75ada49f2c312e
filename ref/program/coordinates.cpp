// SPDX-License-Identifier: Apache-2.0
#include "ref/program/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

void check_range(char letter, double value, const Place& place) {
    if (std::abs(value) > kFarthest) {
        place.refuse(fmt::format("{} is out of range: {:.10g} is beyond {:.10g} mm", letter, value,
                                 kFarthest));
    }
}

}  // namespace

void Coordinates::select_system(int g_code) {
    system_ = g_code <= 590 ? (g_code - 540) / 10 : 5 + g_code - 590;
}

Point Coordinates::target(Block& block, bool machine, const Place& place) const {
    Point point = position_;
    for (int axis = 0; axis < kAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (block.has(letter)) {
            const double value = block.use(letter) * scale(axis);
            const double origin = machine ? 0 : absolute_ ? offset(axis) : position_[axis];
            point[axis] = value + origin;
            check_range(letter, point[axis], place);
        }
    }
    for (int first = 0; first < kAxes; first += 3) {
        const double travel =
            std::hypot(point[first] - position_[first], point[first + 1] - position_[first + 1],
                       point[first + 2] - position_[first + 2]);
        if (travel < kStill) {
            std::copy_n(position_.begin() + first, 3, point.begin() + first);
        }
    }
    return point;
}

double Coordinates::absolute_centre(int axis, double number) const {
    return number * scale(axis) + offset(axis);
}

void Coordinates::set_offset(int system, Block& block, const Place& place) {
    Point& offset = offsets_[system == 0 ? system_ : system - 1];
    for (int axis = 0; axis < kAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (block.has(letter)) {
            offset[axis] = block.use(letter) * scale(axis);
            check_range(letter, offset[axis], place);
        }
    }
}

void Coordinates::set_shift(Block& block, const Place& place) {
    for (int axis = 0; axis < kAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (block.has(letter)) {
            const double value = block.use(letter) * scale(axis);
            shift_[axis] = position_[axis] - offsets_[system_][axis] - value;
            check_range(letter, shift_[axis], place);
        }
    }
    saved_shift_ = shift_;
}

void Coordinates::suspend_shift(bool forget) {
    shift_ = Point{};
    if (forget) {
        saved_shift_ = Point{};
    }
}

}  // namespace curvecore::ref
