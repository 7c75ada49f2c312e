// SPDX-License-Identifier: Apache-2.0
// The interpreter's offsets and stored positions: G10 G28 G30 G43 G49 G52 G92.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {
namespace {

// LinuxCNC's parameter numbers; nine axes each.
constexpr int kStoredByG28 = 5161;
constexpr int kStoredByG30 = 5181;
constexpr int kIsShifted = 5210;
constexpr int kShift = 5211;
constexpr int kSystemInForce = 5220;
constexpr int kSystems = 5221;  // G54 and its rotation behind the axes; 20 numbers each
constexpr int kNextSystem = 20;
constexpr int kSystemCount = 9;

/// Returns the parameter's name, in lower case.
std::string ini_parameter(const std::string& name) {
    std::string parameter = "_ini" + name;
    std::transform(parameter.begin(), parameter.end(), parameter.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return parameter;
}

bool is_angle(int axis) { return axis >= 3 && axis < 6; }

}  // namespace

Point Interpreter::parameters_from(int number) const {
    Point point{};
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        point[axis] = parameters_.number(number + axis) * (is_angle(axis) ? 1 : parameter_unit_);
    }
    return point;
}

void Interpreter::set_parameters_from(int number, const Point& point) {
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        parameters_.set(number + axis, point[axis] / (is_angle(axis) ? 1 : parameter_unit_));
    }
}

void Interpreter::take_system(int number) {
    const int first = kSystems + kNextSystem * number;
    coordinates_.set_system(number,
                            {parameters_from(first), parameters_.number(first + kMachineAxes)});
}

void Interpreter::give_system(int number) {
    const Coordinates::System& system = coordinates_.system(number);
    const int first = kSystems + kNextSystem * number;
    set_parameters_from(first, system.offset);
    parameters_.set(first + kMachineAxes, system.rotation);
}

void Interpreter::give_shift() {
    set_parameters_from(kShift, coordinates_.kept_shift());
    parameters_.set(kIsShifted, coordinates_.is_shifted() ? 1 : 0);
}

void Interpreter::begin(const ProgramStart& start) {
    coordinates_.set_inches(start.unit > 1);
    coordinates_.set_position(start.place);
    kinematic_length_ = start.tool_length;
    for (const auto& [number, value] : start.parameters) parameters_.set(number, value);
    for (const auto& [name, value] : start.ini_numbers) {
        parameters_.compute(ini_parameter(name), [value = value] { return value; });
    }
    for (int i = 0; i < kSystemCount; ++i) take_system(i);
    if (parameters_.number(kIsShifted) != 0) coordinates_.set_shift(parameters_from(kShift));
    const double system = parameters_.number(kSystemInForce);
    if (system >= 1 && system <= kSystemCount) {
        coordinates_.use_system(static_cast<int>(system) - 1);
    }
    parameters_.set(kSystemInForce, coordinates_.modes().system + 1);
}

void Interpreter::select_system(int g_code) {
    coordinates_.select_system(g_code);
    take_system(coordinates_.modes().system);
    parameters_.set(kSystemInForce, coordinates_.modes().system + 1);
}

bool Interpreter::takes_axes(int action) {
    return action == 100 || action == 280 || action == 300 || action == 520 || action == 920;
}

void Interpreter::set_offsets(int action, Block& block, const Codes& codes, const Place& place) {
    const std::optional<int> motion = codes.of(Group::kMotion);
    const bool home = action == 280 || action == 300;
    const bool beside_home = home && (motion == 0 || motion == 10);  // as Fanuc's posts write it
    if (takes_axes(action) && motion && motion != kNoMotion && !beside_home) {
        place.refuse(fmt::format("{} and {} both want the axis words of this block", g_name(action),
                                 g_name(*motion)));
    }
    if ((action == 520 || action == 920) && !block.has_any(kAxisLetters)) {
        place.refuse(fmt::format("{} without axis words", g_name(action)));
    }
    switch (action) {
        case 100:
            set_system(block, place);
            break;
        case 280:
        case 300:
            go_home(parameters_from(action == 300 ? kStoredByG30 : kStoredByG28), block, place);
            break;
        case 281:
        case 301:
            set_parameters_from(action == 301 ? kStoredByG30 : kStoredByG28,
                                coordinates_.position());
            break;
        case 520:
            coordinates_.set_local_shift(block, place);
            break;
        case 920:
            coordinates_.set_shift(block, place);
            break;
        case 923:
            coordinates_.restore_shift();
            break;
        default:
            coordinates_.suspend_shift(action == 921);
    }
    give_shift();
}

void Interpreter::set_system(Block& block, const Place& place) {
    const int kind = block.has('L') ? whole_number('L', block.use('L'), 0, 20, place) : -1;
    if (kind == 1 || kind == 10 || kind == 11) {
        set_tool_table(kind, block, place);
        return;
    }
    if (kind == 0) return;  // the tool table is read again
    if (kind != 2 && kind != 20) {
        place.refuse("G10 wants L2 or L20 (offsets), or L1, L10 or L11 (tools)");
    }
    const bool here = kind == 20;
    if (!block.has('P')) {
        place.refuse(fmt::format("G10 L{} without P (1 is G54, 0 the system in force)", kind));
    }
    const int system = whole_number('P', use_p(block, place), 0, 9, place);
    if (!block.has_any(here ? kAxisLetters : "XYZABCUVWR")) {
        place.refuse(
            fmt::format("G10 L{} without axis words{}", kind, here ? "" : " or a rotation (R)"));
    }
    if (here) {
        coordinates_.set_offset_here(system, block, place);
    } else {
        coordinates_.set_offset(system, block, place);
    }
    give_system(system == 0 ? coordinates_.modes().system : system - 1);
}

/// Moves home by rapids, the first to where the axis words lead.
void Interpreter::go_home(const Point& stored, Block& block, const Place& place) {
    const Point by_way_of = coordinates_.target(block, false, place);
    for (const Point& target : {by_way_of, coordinates_.home(block, by_way_of, stored)}) {
        if (target != coordinates_.position()) line(target, true, place);
    }
}

/// Executes G10 L1, the offset of a tool, and L10 and L11, with which the present place gets these
/// numbers in the system in force or in G59.3.
void Interpreter::set_tool_table(int kind, Block& block, const Place& place) {
    if (!block.has('P')) place.refuse(fmt::format("G10 L{} without P (the tool)", kind));
    const int tool = whole_number('P', use_p(block, place), 1, kLargestTool, place);
    if (!block.has_any("XYZABCUVWRIJQ")) {
        place.refuse(fmt::format("G10 L{} without axis words", kind));
    }
    for (const char letter : std::string_view("IJQ")) block.use(letter);  // angles
    if (block.has('R')) tools_.set_diameter(tool, 2 * block.use('R') * coordinates_.unit());
    const Point* const known = tools_.find(tool);
    Point offset = known != nullptr ? *known : Point{};
    Coordinates without = coordinates_;
    without.set_tool({});
    if (kind == 11) without.use_system(kSystemCount - 1);
    const Point now = without.program_position();
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        if (!block.has(kAxisLetters[axis])) continue;
        const double number = coordinates_.number(block, axis);
        offset[axis] = kind == 1 ? number : now[axis] - number;
    }
    tools_.set(tool, offset);
}

Point Interpreter::tool_offset(int tool, const Place& place) {
    if (tool == 0) tool = tool_;
    if (tool == 0) return {};
    if (const Point* const found = tools_.find(tool)) return *found;
    if (!tools_.file().empty()) {
        place.refuse(fmt::format("the tool table {} has no T{}", tools_.file(), tool));
    }
    moves_.warn(
        "tools have a length of 0: --tools FILE.tbl or a TOOL_TABLE of --machine's .ini "
        "says it",
        place);
    return {};
}

/// Refuses compensation of a tool with a radius; without one it is the programmed path.
void Interpreter::check_radius(Block& block, const Place& place) {
    const bool dynamic = compensation_ % 10 == 1;  // G41.1 D: a diameter
    double diameter = 0;
    if (dynamic) {
        if (!block.has('D')) place.refuse(g_name(compensation_) + " without D, a diameter");
        diameter = std::abs(block.use('D')) * coordinates_.unit();
        if (block.has('L')) block.use('L');
    } else {
        const int given =
            block.has('D') ? whole_number('D', block.use('D'), 0, kLargestTool, place) : tool_;
        diameter = std::abs(tools_.diameter(given));
        if (given != 0 && tools_.find(given) == nullptr) tool_offset(given, place);
        if (tools_.file().empty() && given != 0) {
            moves_.warn(
                "cutter compensation of a tool whose diameter nobody says: the programmed path is "
                "drawn; --tools FILE.tbl says it",
                place);
        }
    }
    if (diameter == 0) return;
    place.refuse(
        fmt::format("{}: cutter compensation of a tool of {:g} mm belongs to LinuxCNC's "
                    "interpreter (--interpreter linuxcnc); D0 draws the programmed path",
                    g_name(compensation_), diameter));
}

void Interpreter::set_tool_length(int code, Block& block, const Place& place) {
    const bool numbered = (code == 430 || code == 432) && block.has('H');
    const int number = numbered ? whole_number('H', block.use('H'), 0, kLargestTool, place) : 0;
    if (code == 490) {
        coordinates_.set_tool({});
        return;
    }
    if (code == 430) {
        take_tool(tool_offset(number, place), place);
        return;
    }
    if (code == 432 && numbered == block.has_any(kAxisLetters)) {
        place.refuse("G43.2 wants either H or axis words");
    }
    Point tool = coordinates_.modes().tool;
    const Point more = numbered ? tool_offset(number, place) : Point{};
    for (int axis = 0; axis < kMachineAxes; ++axis) {
        tool[axis] += more[axis];
        if (!block.has(kAxisLetters[axis])) continue;
        tool[axis] = coordinates_.number(block, axis) + (code == 432 ? tool[axis] : 0);
    }
    take_tool(tool, place);
}

void Interpreter::take_tool(const Point& offset, const Place& place) {
    constexpr double kSame = 1e-6;  // mm
    if (kinematic_length_ && !(std::abs(offset[2] - *kinematic_length_) < kSame)) {
        place.refuse(
            fmt::format("a tool of {:.6g} mm, and [KINS] TOOL_OFFSET is {:.6g} mm: the "
                        "table turns about a point that depends on it",
                        offset[2], *kinematic_length_));
    }
    coordinates_.set_tool(offset);
}

}  // namespace curvecore::ref
