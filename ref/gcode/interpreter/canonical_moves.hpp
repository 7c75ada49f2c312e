// SPDX-License-Identifier: Apache-2.0
// What a controller's own interpreter asks of the machine, call by call, to moves: everything is in
// machine coordinates, mm, mm/s and s (degrees of A B C), offsets and compensations applied.
#pragma once

#include "ref/curve/fit/nurbs.hpp"
#include "ref/gcode/state/coordinates.hpp"
#include "ref/gcode/state/move_list.hpp"

namespace curvecore::ref {

class CanonicalMoves {
  public:
    enum class PathControl { kExactStop, kExactPath, kContinuous };

    /// Where a motion leads, which line asked for it, and how fast: of the path in X Y Z, else in
    /// U V W, else in A B C; a rapid is as fast as the machine allows.
    struct Target {
        int line = 0;
        Point to{};
        double feed = 0;
        bool rapid = false;
    };

    CanonicalMoves(const std::string& file, double fit_tolerance)
        : fit_tolerance_(fit_tolerance), moves_(file) {}

    /// Where the machine stands before the first motion; 0 when nobody says. @throws InputError
    void start(const Point& at);
    /// All motions throw InputError for what cannot be drawn.
    void line(const Target& target);
    /// Counter-clockwise about `normal`, which goes through `centre`; as many turns as are begun.
    void arc(const Target& target, const Vec3& centre, const Vec3& normal, int turns);
    /// From the present place, its first point, to the target, its last.
    void nurbs(const Target& target, const Nurbs& nurbs);
    /// `tolerance`, mm, of the continuous path; 0: the usual one.
    void set_path(PathControl control, double tolerance);
    void dwell(double seconds);
    void stop() { moves_.stop(); }
    void warn(const std::string& text, int line);
    /// MoveList::leave_out()
    void leave_out(const std::string& code, int line, double value = 0);
    /// The program is wrong. @throws InputError
    [[noreturn]] void refuse(const std::string& reason, int line) const;

    const Events& events() const { return moves_.events(); }
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
