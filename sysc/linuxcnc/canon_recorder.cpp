// SPDX-License-Identifier: GPL-2.0-or-later
// A recorder of LinuxCNC's canonical calls as JSON lines: the requests of its interpreter to a
// machine, in machine coordinates, mm, mm/s, degrees and s, with units, offsets, rotation and tool
// length applied.
//
// It is loaded with RTLD_GLOBAL before LinuxCNC's Python module `gcode`, and stands in front of the
// module's functions of the same names: each call is written, then handed on. README.md describes
// the lines.
#include "canon_lines.h"

/// Begins to write to the file descriptor, at most `most` lines; `line` returns the program's line.
extern "C" void record(const char* gcode, int file, long most, int (*line)()) {
    line_now = line;
    module = dlopen(gcode, RTLD_NOW | RTLD_NOLOAD);
    lines = fdopen(file, "w");
    calls_left = most;
}

extern "C" void flush_record() { std::fflush(lines); }

// State

void USE_LENGTH_UNITS(CANON_UNITS units) {
    unit_mm = units == CANON_UNITS_INCHES ? 25.4 : units == CANON_UNITS_CM ? 10 : 1;
    next(USE_LENGTH_UNITS)(units);
}

void SET_G5X_OFFSET(int origin, double x, double y, double z, double a, double b, double c,
                    double u, double v, double w) {
    system_offset = in_mm({x, y, z, a, b, c, u, v, w});
    next(SET_G5X_OFFSET)(origin, x, y, z, a, b, c, u, v, w);
}

void SET_G92_OFFSET(double x, double y, double z, double a, double b, double c, double u, double v,
                    double w) {
    shift = in_mm({x, y, z, a, b, c, u, v, w});
    next(SET_G92_OFFSET)(x, y, z, a, b, c, u, v, w);
}

void SET_XY_ROTATION(double degrees) {
    const double angle = degrees * M_PI / 180;
    turn_cos = std::cos(angle);
    turn_sin = std::sin(angle);
    next(SET_XY_ROTATION)(degrees);
}

void USE_TOOL_LENGTH_OFFSET(EmcPose offset) {
    tool = in_mm(point_of(offset));
    next(USE_TOOL_LENGTH_OFFSET)(offset);
}

void SELECT_PLANE(CANON_PLANE selected) {
    plane = static_cast<int>(selected);
    next(SELECT_PLANE)(selected);
}

void SET_FEED_RATE(double rate) {
    feed = rate;
    next(SET_FEED_RATE)(rate);
}

void SET_FEED_MODE(int of_spindle, int mode) {
    feed_is_per_turn = mode != 0;
    next(SET_FEED_MODE)(of_spindle, mode);
}

void SET_SPINDLE_SPEED(int of_spindle, double turns) {
    if (of_spindle == 0) spindle = std::abs(turns);
    write_left_out("S", turns);
    next(SET_SPINDLE_SPEED)(of_spindle, turns);
}

void START_SPEED_FEED_SYNCH(int of_spindle, double feed_per_turn, bool velocity_mode) {
    per_turn = feed_per_turn;
    next(static_cast<void (*)(int, double, bool)>(START_SPEED_FEED_SYNCH))(
        of_spindle, feed_per_turn, velocity_mode);
}

void STOP_SPEED_FEED_SYNCH() {
    per_turn = 0;
    next(STOP_SPEED_FEED_SYNCH)();
}

void SET_MOTION_CONTROL_MODE(CANON_MOTION_MODE mode, double tolerance) {
    path_tolerance_mm = tolerance * unit_mm;
    const char* const name = mode == CANON_EXACT_STOP   ? "exact stop"
                             : mode == CANON_EXACT_PATH ? "exact path"
                                                        : "continuous";
    write("\"kind\":\"path\",\"mode\":\"" + std::string(name) +
          "\",\"tolerance\":" + number(path_tolerance_mm));
    next(SET_MOTION_CONTROL_MODE)(mode, tolerance);
}

/// Returns the tolerance, which canned cycles read and restore at their end; the module always
/// returns 0.1.
double GET_EXTERNAL_MOTION_CONTROL_TOLERANCE() { return path_tolerance_mm / unit_mm; }

/// Takes the comment by which interpret.py marks the begin of the program.
void COMMENT(const char* text) {
    if (!begun && std::string(text) == "curvecore begins") {
        begun = true;
        at = on_machine({});
        write("\"kind\":\"start\",\"at\":" + list(at));
    }
    next(COMMENT)(text);
}

// Motion

void STRAIGHT_TRAVERSE(int line, double x, double y, double z, double a, double b, double c,
                       double u, double v, double w) {
    write_move("rapid", line, on_machine(in_mm({x, y, z, a, b, c, u, v, w})), "");
    next(STRAIGHT_TRAVERSE)(line, x, y, z, a, b, c, u, v, w);
}

void STRAIGHT_FEED(int line, double x, double y, double z, double a, double b, double c, double u,
                   double v, double w) {
    if (!in_nurbs) write_line(line, on_machine(in_mm({x, y, z, a, b, c, u, v, w})));
    next(STRAIGHT_FEED)(line, x, y, z, a, b, c, u, v, w);
}

void STRAIGHT_PROBE(int line, double x, double y, double z, double a, double b, double c, double u,
                    double v, double w, unsigned char type) {
    warn(line, "a probing move is drawn to its end");
    write_line(line, on_machine(in_mm({x, y, z, a, b, c, u, v, w})));
    write_stop();
    next(STRAIGHT_PROBE)(line, x, y, z, a, b, c, u, v, w, type);
}

void RIGID_TAP(int line, double x, double y, double z, double scale) {
    const Point back = at;
    Point down = on_machine(in_mm({x, y, z}));
    for (int i = 3; i < 9; ++i) down[i] = at[i];
    write_line(line, down);
    write_stop();
    write_line(line, back);
    write_stop();
    next(RIGID_TAP)(line, x, y, z, scale);
}

void ARC_FEED(int line, double first_end, double second_end, double first_axis, double second_axis,
              int rotation, double axis_end, double a, double b, double c, double u, double v,
              double w) {
    const int first = plane == 1 ? 0 : plane == 2 ? 1 : 2;  // XY, YZ, ZX
    const int second = (first + 1) % 3;
    const int third = (first + 2) % 3;
    Point end{0, 0, 0, a, b, c, u, v, w};
    Point centre{};
    end[first] = first_end;
    end[second] = second_end;
    end[third] = axis_end;
    centre[first] = first_axis;
    centre[second] = second_axis;
    const Point target = on_machine(in_mm(end));
    centre = on_machine(in_mm(centre));
    std::array<double, 3> normal{};
    normal[third] = rotation < 0 ? -1 : 1;
    turn(normal[0], normal[1]);
    const std::array<double, 3> place{centre[0], centre[1], centre[2]};
    write_move("arc", line, target,
               ",\"centre\":" + list(place) + ",\"normal\":" + list(normal) +
                   ",\"turns\":" + std::to_string(std::abs(rotation)) + feed_text());
    next(ARC_FEED)(line, first_end, second_end, first_axis, second_axis, rotation, axis_end, a, b,
                   c, u, v, w);
}

void NURBS_FEED(int line, std::vector<CONTROL_POINT> points, unsigned order) {
    const double z = at[2] - system_offset[2] - tool[2] - shift[2];  // stays
    std::string places;
    std::string weights;
    Point target = at;
    for (const CONTROL_POINT& point : points) {
        target = on_machine({point.X * unit_mm, point.Y * unit_mm, z});
        const std::array<double, 3> place{target[0], target[1], target[2]};
        places += (places.empty() ? "" : ",") + list(place);
        weights += (weights.empty() ? "" : ",") + number(point.W);
    }
    for (int i = 3; i < 9; ++i) target[i] = at[i];
    write_move("nurbs", line, target,
               ",\"points\":[" + places + "],\"weights\":[" + weights +
                   "],\"order\":" + std::to_string(order) + feed_text());
    in_nurbs = true;
    next(NURBS_FEED)(line, points, order);
    in_nurbs = false;
}

void DWELL(double seconds) {
    write("\"kind\":\"dwell\",\"seconds\":" + number(seconds));
    next(DWELL)(seconds);
}

// Calls at which the machine stands, and actions besides motion

namespace {

void write_stop(const char* code) {
    write_stop();
    write_left_out(code);
}

void write_analog(const char* code, int output, double value) {
    const std::string other = std::string(code) + " E" + std::to_string(output);
    write_left_out(output == 0 ? code : other.c_str(), value);
}

}  // namespace

void SELECT_TOOL(int tool) {
    write_left_out("T", tool);
    next(SELECT_TOOL)(tool);
}

void CHANGE_TOOL(int slot) {
    write_stop("M6");
    next(CHANGE_TOOL)(slot);
}

void PROGRAM_STOP() {
    write_stop("M0");
    next(PROGRAM_STOP)();
}

void OPTIONAL_PROGRAM_STOP() {
    write_stop("M1");
    next(OPTIONAL_PROGRAM_STOP)();
}

void PALLET_SHUTTLE() {
    write_stop("M60");
    next(PALLET_SHUTTLE)();
}

void START_SPINDLE_CLOCKWISE(int of_spindle, int wait) {
    spindle_on = true;
    write_stop("M3");
    next(START_SPINDLE_CLOCKWISE)(of_spindle, wait);
}

void START_SPINDLE_COUNTERCLOCKWISE(int of_spindle, int wait) {
    spindle_on = true;
    write_stop("M4");
    next(START_SPINDLE_COUNTERCLOCKWISE)(of_spindle, wait);
}

/// Stops the spindle; M2 calls it, too.
void STOP_SPINDLE_TURNING(int of_spindle) {
    write_stop();
    if (spindle_on) write_left_out("M5");
    spindle_on = false;
    next(STOP_SPINDLE_TURNING)(of_spindle);
}

void ORIENT_SPINDLE(int of_spindle, double angle, int mode) {
    write_stop("M19");
    next(ORIENT_SPINDLE)(of_spindle, angle, mode);
}

void MIST_ON() {
    write_left_out("M7");
    next(MIST_ON)();
}

void FLOOD_ON() {
    write_left_out("M8");
    next(FLOOD_ON)();
}

void FLOOD_OFF() {
    write_left_out("M9");
    next(FLOOD_OFF)();
}

void SET_MOTION_OUTPUT_BIT(int index) {
    write_left_out("M62", index);
    next(SET_MOTION_OUTPUT_BIT)(index);
}

void CLEAR_MOTION_OUTPUT_BIT(int index) {
    write_left_out("M63", index);
    next(CLEAR_MOTION_OUTPUT_BIT)(index);
}

void SET_AUX_OUTPUT_BIT(int index) {
    write_left_out("M64", index);
    next(SET_AUX_OUTPUT_BIT)(index);
}

void CLEAR_AUX_OUTPUT_BIT(int index) {
    write_left_out("M65", index);
    next(CLEAR_AUX_OUTPUT_BIT)(index);
}

int WAIT(int index, int type, int mode, double timeout) {
    write_left_out("M66");
    return next(WAIT)(index, type, mode, timeout);
}

void SET_MOTION_OUTPUT_VALUE(int index, double value) {
    write_analog("M67", index, value);
    next(SET_MOTION_OUTPUT_VALUE)(index, value);
}

void SET_AUX_OUTPUT_VALUE(int index, double value) {
    write_analog("M68", index, value);
    next(SET_AUX_OUTPUT_VALUE)(index, value);
}

void DISABLE_FEED_OVERRIDE() {
    write_left_out("M50");
    next(DISABLE_FEED_OVERRIDE)();
}

void DISABLE_SPEED_OVERRIDE(int of_spindle) {
    write_left_out("M51");
    next(DISABLE_SPEED_OVERRIDE)(of_spindle);
}

void ENABLE_ADAPTIVE_FEED() {
    write_left_out("M52");
    next(ENABLE_ADAPTIVE_FEED)();
}

void DISABLE_FEED_HOLD() {
    write_left_out("M53");
    next(DISABLE_FEED_HOLD)();
}
