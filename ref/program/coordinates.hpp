// SPDX-License-Identifier: Apache-2.0
// Where a program's numbers lie on the machine: units, distance mode, offsets, current point.
//
//     machine = number * unit + offset of G54..G59.3 + offset of G92      (A B C in degrees)
#pragma once

#include <array>
#include <string_view>

#include "ref/curve/vec3.hpp"
#include "ref/program/block.hpp"

namespace curvecore::ref {

constexpr std::string_view kAxisLetters = "XYZABCUVW";
constexpr int kAxes = 9;
using Point = std::array<double, kAxes>;

constexpr double kStill = 1e-9;    // mm: what moves less stands
constexpr double kFarthest = 1e6;  // mm

inline Vec3 xyz(const Point& point) { return {point[0], point[1], point[2]}; }

class Coordinates {
  public:
    void set_inches(bool inches) { unit_ = inches ? 25.4 : 1; }
    void set_absolute(bool absolute) { absolute_ = absolute; }
    void select_system(int g_code);  // 540 .. 593

    bool absolute() const { return absolute_; }
    double unit() const { return unit_; }  // mm per program unit
    bool inches() const { return unit_ != 1; }
    const Point& position() const { return position_; }
    void set_position(const Point& point) { position_ = point; }
    /// Where the current point lies for the program: in its units, with all offsets.
    double programmed(int axis) const { return (position_[axis] - offset(axis)) / scale(axis); }
    /// On the machine, in the program's units.
    double on_machine(int axis) const { return position_[axis] / scale(axis); }
    int system() const { return system_; }  // 0 is G54

    /// Where the block's axis words lead; in machine coordinates for G53. Groups of axes (X Y Z,
    /// A B C, U V W) that move by less than 1e-9 mm keep their place exactly.
    Point target(Block& block, bool machine, const Place& place) const;
    /// A centre word of G90.1 on the machine.
    double absolute_centre(int axis, double number) const;

    /// G10 L2 P.. with axis words; `system` 0 is the one in force.
    void set_offset(int system, Block& block, const Place& place);
    /// G92 with axis words: the current point gets these coordinates.
    void set_shift(Block& block, const Place& place);
    void suspend_shift(bool forget);  // G92.2, G92.1
    void restore_shift() { shift_ = saved_shift_; }

  private:
    double scale(int axis) const { return axis >= 3 && axis < 6 ? 1 : unit_; }
    double offset(int axis) const { return offsets_[system_][axis] + shift_[axis]; }

    double unit_ = 1;
    bool absolute_ = true;
    int system_ = 0;
    std::array<Point, 9> offsets_{};  // G54 .. G59.3
    Point shift_{};                   // G92
    Point saved_shift_{};             // kept for G92.3
    Point position_{};                // machine
};

}  // namespace curvecore::ref
