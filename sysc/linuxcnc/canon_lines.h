// SPDX-License-Identifier: GPL-2.0-or-later
// State that canon_recorder.cpp keeps between LinuxCNC's calls, and its writer of JSON lines.
#pragma once

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <canon.hh>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using Point = std::array<double, 9>;  // X Y Z A B C U V W

void* module = nullptr;  // gcode
FILE* lines = nullptr;
long calls_left = 0;
int (*line_now)() = nullptr;  // line of the program, for calls that do not pass it

double unit_mm = 25.4;  // the program's unit
double path_tolerance_mm = 0;
Point system_offset{}, shift{}, tool{};
double turn_cos = 1, turn_sin = 0;
int plane = 1;        // LinuxCNC's number: arcs are in XY, YZ or ZX
double feed = 0;      // feed a minute, in the program's unit
double per_turn = 0;  // feed a turn of the spindle, in modes that use it
bool feed_is_per_turn = false;
double spindle = 0;  // turns a minute
bool spindle_on = false;
Point at{};  // position on the machine
bool begun = false;
bool in_nurbs = false;  // true: the module makes chords of the curve, which are ignored

/// Returns the module's function that a function of this file stands in front of.
template <class Function>
Function* next(Function* own) {
    Dl_info info{};
    dladdr(reinterpret_cast<void*>(own), &info);
    return reinterpret_cast<Function*>(dlsym(module, info.dli_sname));
}

void write(const std::string& line) {
    if (--calls_left < 0) {
        std::fputs(
            "{\"kind\":\"error\",\"line\":0,\"text\":\"the program asks for more moves than "
            "the limit: an endless loop?\"}\n",
            lines);
        std::fflush(lines);
        _exit(1);
    }
    if (std::fprintf(lines, "{%s}\n", line.c_str()) < 0) _exit(1);
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value);
    return text.data();
}

template <class Numbers>
std::string list(const Numbers& numbers) {
    std::string text;
    for (const double value : numbers) text += (text.empty() ? "" : ",") + number(value);
    return "[" + text + "]";
}

bool is_angle(int axis) { return axis >= 3 && axis < 6; }

/// Converts a point in the program's unit to mm and degrees.
Point in_mm(Point point) {
    for (int i = 0; i < 9; ++i) {
        if (!is_angle(i)) point[i] *= unit_mm;
    }
    return point;
}

void turn(double& x, double& y) {
    const double before = x;
    x = before * turn_cos - y * turn_sin;
    y = before * turn_sin + y * turn_cos;
}

/// Converts a point of the program, mm, to machine coordinates.
Point on_machine(Point point) {
    for (int i = 0; i < 9; ++i) point[i] += shift[i];
    turn(point[0], point[1]);
    for (int i = 0; i < 9; ++i) point[i] += system_offset[i] + tool[i];
    return point;
}

/// Feed in mm/s; degrees/s on a path of angles alone.
double speed(bool of_angles) {
    const double rate = per_turn > 0       ? per_turn * spindle
                        : feed_is_per_turn ? feed * spindle
                                           : feed;
    return rate * (of_angles ? 1 : unit_mm) / 60;
}

bool only_angles_change(const Point& target) {
    for (int i = 0; i < 9; ++i) {
        if (!is_angle(i) && target[i] != at[i]) return false;
    }
    return true;
}

void write_move(const char* kind, int line, const Point& target, const std::string& more) {
    write("\"kind\":\"" + std::string(kind) + "\",\"line\":" + std::to_string(line) +
          ",\"to\":" + list(target) + more);
    at = target;
}

std::string feed_text(bool of_angles = false) { return ",\"feed\":" + number(speed(of_angles)); }

void write_line(int line, const Point& target) {
    write_move("line", line, target, feed_text(only_angles_change(target)));
}

void write_stop() { write("\"kind\":\"stop\""); }

void warn(int line, const char* text) {
    write("\"kind\":\"warning\",\"line\":" + std::to_string(line) + ",\"text\":\"" + text + "\"");
}

/// Writes an action besides motion; `value`: that of S.
void write_left_out(const char* code, double value = 0) {
    if (!begun) return;
    write("\"kind\":\"left out\",\"code\":\"" + std::string(code) +
          "\",\"line\":" + std::to_string(line_now()) + ",\"value\":" + number(value));
}

Point point_of(const EmcPose& pose) {
    return {pose.tran.x, pose.tran.y, pose.tran.z, pose.a, pose.b, pose.c, pose.u, pose.v, pose.w};
}

}  // namespace
