// SPDX-License-Identifier: Apache-2.0
// Where a program's numbers lie on the machine: units, distance mode, offsets, current point.
//
//     machine = R (number * unit + shift) + offset + tool      (A B C in degrees)
//
// of the shift by G92 or G52, offset and rotation R about Z of G54..G59.3, and the tool's length.
#pragma once

#include <array>
#include <string_view>

#include "ref/curve/axes.hpp"
#include "ref/curve/vec3.hpp"
#include "ref/gcode/blocks/block.hpp"

namespace curvecore::ref {

using Point = AxisVector;

constexpr double kStill = 1e-9;    // mm: what moves less stands
constexpr double kFarthest = 1e6;  // mm

inline Vec3 xyz(const Point& point) { return {point[0], point[1], point[2]}; }

class Coordinates {
  public:
    /// Of these a program can keep and restore what holds.
    struct Modes {
        double unit = 1;  // mm per program unit
        bool absolute = true;
        bool diameter = false;  // G7: X is twice as far
        int system = 0;
        Point tool{};
    };

    void set_inches(bool inches) { modes_.unit = inches ? 25.4 : 1; }
    void set_absolute(bool absolute) { modes_.absolute = absolute; }
    void set_diameter(bool diameter) { modes_.diameter = diameter; }
    void set_tool(const Point& offset) { modes_.tool = offset; }
    void select_system(int g_code);  // 540 .. 593

    const Modes& modes() const { return modes_; }
    void restore(const Modes& modes) { modes_ = modes; }
    bool absolute() const { return modes_.absolute; }
    double unit() const { return modes_.unit; }
    bool inches() const { return modes_.unit != 1; }
    const Point& position() const { return position_; }
    void set_position(const Point& point) { position_ = point; }
    /// Where the current point lies for the program: in its units, with all offsets.
    double programmed(int axis) const { return program_position()[axis] / scale(axis); }
    /// On the machine, in the program's units.
    double on_machine(int axis) const { return position_[axis] / scale(axis); }

    /// Where the block's axis words lead; in machine coordinates for G53. Groups of axes (X Y Z,
    /// A B C, U V W) that move by less than 1e-9 mm keep their place exactly.
    Point target(Block& block, bool machine, const Place& place) const;
    /// From a place, by way of which the block leads, to the stored position: of the axes that the
    /// block names, of all when it names none.
    Point home(const Block& block, const Point& from, const Point& stored) const;
    /// The block's word for an axis, mm or degrees.
    double number(Block& block, int axis) const;
    /// A centre word of G90.1, in the machine's coordinates turned to the program's axes.
    double absolute_centre(int axis, double number) const;

    /// A place on the machine as the program counts it, mm; and where such a point is on the
    /// machine, exactly at the present place where it is as near as target() says.
    Point in_program(const Point& on_machine) const;
    Point program_position() const { return in_program(position_); }
    Point on_machine(const Point& program, const Place& place) const;
    /// A vector along the program's axes to one along the machine's, and back.
    Vec3 turned(const Vec3& vector) const;
    Vec3 turned_back(const Vec3& vector) const;

    /// Of G54 .. G59.3, 0 .. 8: where its zero is on the machine, turned by degrees about Z.
    struct System {
        Point offset{};
        double rotation = 0;
    };
    const System& system(int number) const { return systems_[number]; }
    void set_system(int number, const System& system) { systems_[number] = system; }
    void use_system(int number) { modes_.system = number; }
    /// Of G92 and G52, as G92.3 brings it back.
    const Point& kept_shift() const { return saved_shift_; }
    bool is_shifted() const { return shift_ != Point{}; }
    void set_shift(const Point& shift) { shift_ = saved_shift_ = shift; }

    /// G10 L2 P.. with axis words and R; `system` 0 is the one in force.
    void set_offset(int system, Block& block, const Place& place);
    /// G10 L20 P..: the current point gets these coordinates.
    void set_offset_here(int system, Block& block, const Place& place);
    /// G92 with axis words: the current point gets these coordinates.
    void set_shift(Block& block, const Place& place);
    /// G52 with axis words.
    void set_local_shift(Block& block, const Place& place);
    void suspend_shift(bool forget);  // G92.2, G92.1
    void restore_shift() { shift_ = saved_shift_; }

  private:
    double scale(int axis) const { return axis >= 3 && axis < 6 ? 1 : modes_.unit; }
    double rotation() const { return systems_[modes_.system].rotation; }
    /// A place on the machine, counted in a system without the shift.
    Point counted_in(const System& system, const Point& on_machine) const;
    void keep_still(Point& point) const;
    /// Of the program's zero, in the machine's coordinates turned to the program's axes.
    Point origin() const;

    Modes modes_;
    std::array<System, 9> systems_{};  // G54 .. G59.3
    Point shift_{};                    // G92, G52
    Point saved_shift_{};              // kept for G92.3
    Point position_{};                 // machine
};

}  // namespace curvecore::ref
