// SPDX-License-Identifier: Apache-2.0
// The interpreter of a program's blocks: modal state in, moves out.
//
// A block is executed in RS274/NGC's order: feed, spindle and tool, dwell, modes, offsets, motion,
// stop. There is one difference: an F word is read in the units of its own block (G20 F10 is 10
// inches a minute). The machine starts at 0 on all axes with G8 G17 G21 (a machine of inches: G20)
// G40 G49 G54 G64 G90 G91.1 G94 G99 and no motion mode; stored positions (G28, G30), offsets and
// lengths of tools are those of its ProgramStart.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "ref/curve/fit/nurbs.hpp"
#include "ref/gcode/blocks/codes.hpp"
#include "ref/gcode/cycles/canned_cycles.hpp"
#include "ref/gcode/state/coordinates.hpp"
#include "ref/gcode/state/modes.hpp"
#include "ref/gcode/state/move_list.hpp"
#include "ref/gcode/state/named_curve.hpp"
#include "ref/gcode/state/program_start.hpp"
#include "ref/moves/arc_geometry.hpp"

namespace curvecore::ref {

class Interpreter {
  public:
    /// @param parameters outlives this object, whose values it can query afterwards
    /// @param table of curves that comments name, which outlives the moves; null: there is none
    Interpreter(const std::string& file, double fit_tolerance, ProgramParameters& parameters,
                const ProgramStart& start = {}, const CurveTable* table = nullptr);
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    /// Modal state that M70 saves and M72 restores: all but the motion mode.
    struct State {
        Modes modes;
        Coordinates::Modes coordinates;
    };
    State state() const { return {modes_, coordinates_.modes()}; }
    void restore(const State& state) {
        modes_ = state.modes;
        coordinates_.restore(state.coordinates);
    }

    /// Executes a block; returns false if it ends the program. @throws InputError
    bool execute(Block block, const Place& place);
    /// Lets the next G1 end the curve of an active comment. @throws InputError
    void name_curve(const std::string& text, const Place& place);
    /// Notes a code of another dialect that asks for more than motion; `waits`: the machine stands
    /// still at it.
    void note(const std::string& code, bool waits, const Place& place);
    void warn(const std::string& text, const Place& place) { moves_.warn(text, place); }
    const Events& events() const { return moves_.events(); }
    void obey(const Obeyed& codes) { moves_.obey(codes); }
    /// Hands over moves in order; also the `last` one, behind which a stop or a dwell may still
    /// come.
    std::vector<Move> take(bool last) { return moves_.take(last); }
    /// Returns the rest of the program, with all of its warnings.
    /// @throws InputError when it has no moves, an arc lacks its end point or a NURBS its G5.3.
    Program finish();

  private:
    void give_values();
    void resolve_polar(Block& block, const Codes& codes, const Place& place) const;
    void set_feed(Block& block, const Codes& codes, const Place& place);
    void use_spindle_and_tool(Block& block, const Codes& codes, const Place& place);
    void set_modes(Block& block, const Codes& codes, const Place& place);
    static double use_p(Block& block, const Place& place);
    void dwell(Block& block, const Place& place);
    void set_path_control(int control, Block& block, const Place& place);
    void check_radius(Block& block, const Place& place);
    void set_tool_length(int code, Block& block, const Place& place);
    /// @throws InputError: the kinematics are made for another length
    void take_tool(const Point& offset, const Place& place);
    static bool takes_axes(int action);
    void set_offsets(int action, Block& block, const Codes& codes, const Place& place);
    void set_system(Block& block, const Place& place);
    void set_tool_table(int kind, Block& block, const Place& place);
    Point tool_offset(int tool, const Place& place);
    /// Returns nine axes from a parameter on: offsets and stored positions are parameters, too.
    Point parameters_from(int number) const;
    void set_parameters_from(int number, const Point& point);
    void take_system(int number);
    void select_system(int g_code);
    void give_system(int number);
    void give_shift();
    void begin(const ProgramStart& start);
    void go_home(const Point& stored, Block& block, const Place& place);
    void use_leftovers(Block& block, const Place& place);
    void move(Block& block, const Codes& codes, const Place& place);
    void take_rapid(const Place& place);
    void line(const Point& target, bool rapid, const Place& place);
    void cycle(bool again, Block& block, const Place& place);
    void carry_out(const CycleStep& step, const Place& place);
    void arc(Block& block, const Place& place);
    Eigen::Vector2d plane_centre(Block& block, const Eigen::Vector2d& start,
                                 const Place& place) const;
    Eigen::Vector2d fitted_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                                  const Eigen::Vector2d& centre, const Place& place);
    ArcTolerance arc_tolerance() const;
    void space_arc(Block& block, const Codes& codes, const Place& place);
    void check_nothing_waits(const Place& place) const;
    void check_spline(Block& block, const Place& place);
    void spline(Block& block, const Place& place);
    Bezier cubic_legs(Block& block, const Vec3& start, const Vec3& end, const Place& place);
    Bezier quadratic_legs(Block& block, const Vec3& start, const Vec3& end,
                          const Place& place) const;
    void open_nurbs(Block& block, const Place& place);
    void nurbs_block(Block& block, const Codes& codes, const Place& place);
    void control_point(Block& block, const Place& place);
    void close_nurbs(const Place& place);
    [[noreturn]] void refuse_curve(const Place& place) const;
    void table_curve(Block& block, const Place& place);

    Move move_to(const Point& target, const Place& place) const;
    void add(Move move, const Point& target, const Place& place);
    void add_curve(const std::vector<Cubic>& cubics, const Point& target, const Place& place);
    /// Returns the feed of a move that is a part, or all, of a block's path of this length.
    double feed_on(const Move& move, double length, const Place& place) const;

    /// A point on a G2.4 arc that waits for the block with the end point.
    struct Middle {
        Point start;
        Vec3 point;
        int line;
        std::optional<double> feed;  // F of that block, for G93
    };

    /// A curve that G5.2 began and that waits for G5.3.
    struct OpenNurbs {
        Nurbs curve;
        Point last;  // control point
        std::optional<int> order;
        std::optional<double> feed;  // F of its blocks, for G93
        int line;
    };

    double fit_tolerance_;  // mm
    ProgramParameters& parameters_;
    MoveList moves_;
    Coordinates coordinates_;
    Modes modes_;
    int motion_ = kNoMotion;  // G code in tenths
    bool motion_said_ = false;
    bool centres_shown_ = false;  // as relative or absolute, by G90.1 G91.1 or by an arc
    ToolTable tools_;
    int compensation_ = 400;  // G code in tenths; the tool has no radius
    int selected_tool_ = 0;
    int tool_ = 0;                         // tool in the spindle
    double parameter_unit_;                // mm, the machine's unit
    std::optional<double> arc_tolerance_;  // mm
    CannedCycles canned_cycles_;
    std::optional<Middle> middle_;
    std::optional<OpenNurbs> nurbs_;
    std::optional<double> kinematic_length_;  // mm
    const CurveTable* table_;
    std::optional<NamedCurve> curve_;  // that waits for its end
    std::optional<Vec3> last_leg_;     // P Q R of a G5 that is still in force, mm
};

}  // namespace curvecore::ref
