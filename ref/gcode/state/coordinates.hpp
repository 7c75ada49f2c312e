// SPDX-License-Identifier: Apache-2.0
// Coordinates of a program on the machine: units, distance mode, offsets, current point.
//
//     machine = R (number * unit + shift) + offset + tool      (A B C in degrees)
//
// with the shift by G92 or G52, offset and rotation R about Z of G54..G59.3, and the tool's length.
#pragma once

#include <array>
#include <string_view>

#include "ref/curve/axes.hpp"
#include "ref/curve/vec3.hpp"
#include "ref/gcode/blocks/block.hpp"

namespace curvecore::ref {

using Point = AxisVector;

constexpr double kStill = 1e-9;    // mm: smaller motion counts as rest
constexpr double kFarthest = 1e6;  // mm

inline Vec3 xyz(const Point& point) { return {point[0], point[1], point[2]}; }
inline Aux aux_of(const Point& point) {
    return {point[3], point[4], point[5], point[6], point[7], point[8]};
}

class Coordinates {
  public:
    /// Modes that a program can save and restore.
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
    /// The current point in the program's coordinates: in its units, with all offsets.
    double programmed(int axis) const { return program_position()[axis] / scale(axis); }
    /// The current point on the machine, in the program's units.
    double on_machine(int axis) const { return position_[axis] / scale(axis); }

    /// Target of the block's axis words; in machine coordinates for G53. Groups of axes (X Y Z, A B
    /// C, U V W) that move by less than 1e-9 mm keep their place exactly.
    Point target(Block& block, bool machine, const Place& place) const;
    /// Target of a return to the stored position by way of `from`: for the axes that the block
    /// names, for all if it names none.
    Point home(const Block& block, const Point& from, const Point& stored) const;
    /// The block's word for an axis, mm or degrees.
    double number(Block& block, int axis) const;
    /// A centre word of G90.1 in machine coordinates turned to the program's axes.
    double absolute_centre(int axis, double number) const;

    /// Conversion of a place on the machine to the program's coordinates, mm, and back; a point as
    /// near to the present place as target() says is exactly there.
    Point in_program(const Point& on_machine) const;
    Point program_position() const { return in_program(position_); }
    Point on_machine(const Point& program, const Place& place) const;
    /// Conversion of a vector along the program's axes to one along the machine's, and back.
    Vec3 turned(const Vec3& vector) const;
    Vec3 turned_back(const Vec3& vector) const;

    /// One of G54 .. G59.3, 0 .. 8: the place of its zero on the machine, turned by degrees about
    /// Z.
    struct System {
        Point offset{};
        double rotation = 0;
    };
    const System& system(int number) const { return systems_[number]; }
    void set_system(int number, const System& system) { systems_[number] = system; }
    void use_system(int number) { modes_.system = number; }
    /// The shift of G92 and G52 that G92.3 restores.
    const Point& kept_shift() const { return saved_shift_; }
    bool is_turned() const { return rotation() != 0; }
    bool is_shifted() const { return shift_ != Point{}; }
    void set_shift(const Point& shift) { shift_ = saved_shift_ = shift; }

    /// Executes G10 L2 P.. with axis words and R; `system` 0 is the one in force.
    void set_offset(int system, Block& block, const Place& place);
    /// Executes G10 L20 P..: the current point gets these coordinates.
    void set_offset_here(int system, Block& block, const Place& place);
    /// Executes G92 with axis words: the current point gets these coordinates.
    void set_shift(Block& block, const Place& place);
    /// Executes G52 with axis words.
    void set_local_shift(Block& block, const Place& place);
    void suspend_shift(bool forget);  // G92.2, G92.1
    void restore_shift() { shift_ = saved_shift_; }

  private:
    double scale(int axis) const { return axis >= 3 && axis < 6 ? 1 : modes_.unit; }
    double rotation() const { return systems_[modes_.system].rotation; }
    /// A place on the machine in the coordinates of a system without the shift.
    Point counted_in(const System& system, const Point& on_machine) const;
    void keep_still(Point& point) const;
    /// The program's zero in machine coordinates turned to the program's axes.
    Point origin() const;

    Modes modes_;
    std::array<System, 9> systems_{};  // G54 .. G59.3
    Point shift_{};                    // G92, G52
    Point saved_shift_{};              // kept for G92.3
    Point position_{};                 // on the machine
};

}  // namespace curvecore::ref
