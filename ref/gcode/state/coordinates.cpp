// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/state/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

void check_range(char letter, double value, const Place& place) {
    if (std::abs(value) > kFarthest) {
        place.refuse(fmt::format("{} is out of range: {:.10g} is beyond {:.10g} mm", letter, value,
                                 kFarthest));
    }
}

/// Turns a point about Z; an angle of 0 leaves it exactly as it is.
Point turn(Point point, double degrees) {
    if (degrees == 0) return point;
    const double c = std::cos(degrees * kRadiansPerDegree);
    const double s = std::sin(degrees * kRadiansPerDegree);
    const double x = point[0];
    point[0] = c * x - s * point[1];
    point[1] = s * x + c * point[1];
    return point;
}

Vec3 turn(const Vec3& vector, double degrees) {
    return xyz(turn(Point{vector.x(), vector.y(), vector.z()}, degrees));
}

Point operator+(Point a, const Point& b) {
    for (int axis = 0; axis < kMachineAxes; ++axis) a[axis] += b[axis];
    return a;
}

Point operator-(Point a, const Point& b) {
    for (int axis = 0; axis < kMachineAxes; ++axis) a[axis] -= b[axis];
    return a;
}

}  // namespace

void Coordinates::select_system(int g_code) {
    modes_.system = g_code <= 590 ? (g_code - 540) / 10 : 5 + g_code - 590;
}

double Coordinates::number(Block& block, int axis) const {
    const double value = block.use(kAxisLetters[axis]) * scale(axis);
    return axis == 0 && modes_.diameter ? value / 2 : value;
}

Point Coordinates::origin() const {
    return turn(systems_[modes_.system].offset + modes_.tool, -rotation()) + shift_;
}

Point Coordinates::target(Block& block, bool machine, const Place& place) const {
    const double angle = machine ? 0 : rotation();
    const Point zero = machine ? Point{} : origin();
    Point point = turn(position_, -angle);
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        if (!block.has(kAxisLetters[axis])) continue;
        const bool absolute = machine || modes_.absolute;
        point[axis] = number(block, axis) + (absolute ? zero[axis] : point[axis]);
        check_range(kAxisLetters[axis], point[axis], place);
    }
    point = turn(point, angle);
    keep_still(point);
    return point;
}

/// Keeps groups of axes that all but stand exactly in place.
void Coordinates::keep_still(Point& point) const {
    for (int first = 0; first < kMachineAxes; first += 3) {
        const double travel =
            std::hypot(point[first] - position_[first], point[first + 1] - position_[first + 1],
                       point[first + 2] - position_[first + 2]);
        if (travel < kStill) {
            std::copy_n(position_.begin() + first, 3, point.begin() + first);
        }
    }
}

Point Coordinates::home(const Block& block, const Point& from, const Point& stored) const {
    if (!block.has_any(kAxisLetters)) return stored;
    Point point = turn(from, -rotation());
    const Point end = turn(stored, -rotation());
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        if (block.has(kAxisLetters[axis])) point[axis] = end[axis];
    }
    return turn(point, rotation());
}

double Coordinates::absolute_centre(int axis, double number) const {
    return number * scale(axis) + origin()[axis];
}

Point Coordinates::counted_in(const System& system, const Point& on_machine) const {
    return turn(on_machine - system.offset - modes_.tool, -system.rotation);
}

Point Coordinates::in_program(const Point& on_machine) const {
    return counted_in(systems_[modes_.system], on_machine) - shift_;
}

Point Coordinates::on_machine(const Point& program, const Place& place) const {
    Point point = turn(program + origin(), rotation());
    keep_still(point);
    for (int axis = 0; axis < kMachineAxes; ++axis)
        check_range(kAxisLetters[axis], point[axis], place);
    return point;
}

Vec3 Coordinates::turned(const Vec3& vector) const { return turn(vector, rotation()); }

Vec3 Coordinates::turned_back(const Vec3& vector) const { return turn(vector, -rotation()); }

void Coordinates::set_offset(int system, Block& block, const Place& place) {
    System& set = systems_[system == 0 ? modes_.system : system - 1];
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (!block.has(letter)) continue;
        set.offset[axis] = number(block, axis);
        check_range(letter, set.offset[axis], place);
    }
    if (block.has('R')) set.rotation = block.use('R');
}

void Coordinates::set_offset_here(int system, Block& block, const Place& place) {
    System& set = systems_[system == 0 ? modes_.system : system - 1];
    const Point now = counted_in(set, position_);
    Point wanted = now;
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        if (block.has(kAxisLetters[axis])) wanted[axis] = number(block, axis) + shift_[axis];
    }
    set.offset = set.offset + turn(now - wanted, set.rotation);
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        check_range(kAxisLetters[axis], set.offset[axis], place);
    }
}

void Coordinates::set_shift(Block& block, const Place& place) {
    const Point now = counted_in(systems_[modes_.system], position_);
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (!block.has(letter)) continue;
        shift_[axis] = now[axis] - number(block, axis);
        check_range(letter, shift_[axis], place);
    }
    saved_shift_ = shift_;
}

void Coordinates::set_local_shift(Block& block, const Place& place) {
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        const char letter = kAxisLetters[axis];
        if (!block.has(letter)) continue;
        shift_[axis] = number(block, axis);
        check_range(letter, shift_[axis], place);
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
