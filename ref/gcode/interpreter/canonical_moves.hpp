// SPDX-License-Identifier: Apache-2.0
// The canonical calls of a controller's own interpreter, made into moves: everything is in machine
// coordinates, mm, mm/s and s (degrees of A B C), with offsets and compensations applied.
#pragma once

#include "ref/curve/fit/nurbs.hpp"
#include "ref/gcode/state/coordinates.hpp"
#include "ref/gcode/state/move_list.hpp"

namespace curvecore::ref {

class CanonicalMoves {
  public:
    enum class PathControl { kExactStop, kExactPath, kContinuous };

    /// The target of a motion, the line that asked for it, and its speed along the path in X Y Z,
    /// else in U V W, else in A B C; a rapid is as fast as the machine allows.
    struct Target {
        int line = 0;
        Point to{};
        double feed = 0;
        bool rapid = false;
    };

    CanonicalMoves(const std::string& file, double fit_tolerance)
        : fit_tolerance_(fit_tolerance), moves_(file) {}

    /// Sets the machine's position before the first motion; 0 by default. @throws InputError
    void start(const Point& at);
    /// Adds a line. All motions throw InputError if they cannot be drawn.
    void line(const Target& target);
    /// Adds an arc, counter-clockwise about `normal` through `centre`; `turns` counts every begun
    /// turn.
    void arc(const Target& target, const Vec3& centre, const Vec3& normal, int turns);
    /// Adds a NURBS from the present place, its first point, to the target, its last.
    void nurbs(const Target& target, const Nurbs& nurbs);
    /// Sets the path mode; `tolerance` in mm applies to the continuous path, 0: the default.
    void set_path(PathControl control, double tolerance);
    void dwell(double seconds);
    void stop() { moves_.stop(); }
    void warn(const std::string& text, int line);
    /// Calls MoveList::leave_out().
    void leave_out(const std::string& code, int line, double value = 0);
    /// Reports an invalid program. @throws InputError
    [[noreturn]] void refuse(const std::string& reason, int line) const;

    const Events& events() const { return moves_.events(); }
    void obey(const Obeyed& codes) { moves_.obey(codes); }
    std::vector<Move> take(bool last) { return moves_.take(last); }
    Program finish() { return moves_.finish(); }

  private:
    Place place(int line) const { return {moves_.file(), line}; }
    Move move_to(const Target& target) const;
    void add(const Move& move, const Place& place);

    double fit_tolerance_;  // mm
    MoveList moves_;
    Point at_{};
    bool moved_ = false;
    bool exact_stop_ = false;
    double tolerance_ = kPathTolerance;  // mm
};

}  // namespace curvecore::ref
