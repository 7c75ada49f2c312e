// SPDX-License-Identifier: Apache-2.0
// The interpreter's offsets and stored positions: G10 G28 G30 G43 G49 G52 G92.
#include <fmt/format.h>

#include <cmath>

#include "ref/program/interpreter.hpp"

namespace curvecore::ref {

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
            go_home(stored_[action == 300 ? 1 : 0], block, place);
            break;
        case 281:
        case 301:
            stored_[action == 301 ? 1 : 0] = coordinates_.position();
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
}

void Interpreter::set_system(Block& block, const Place& place) {
    const double kind = block.has('L') ? block.use('L') : -1;
    if (kind != 2 && kind != 20) {
        place.refuse("of G10 only L2 and L20 are supported");
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
}

/// By rapids, the first to where the axis words lead.
void Interpreter::go_home(const Point& stored, Block& block, const Place& place) {
    const Point by_way_of = coordinates_.target(block, false, place);
    for (const Point& target : {by_way_of, coordinates_.home(block, by_way_of, stored)}) {
        if (target != coordinates_.position()) line(target, true, place);
    }
}

void Interpreter::set_tool_length(int code, Block& block, const Place& place) {
    if (code == 490) {
        coordinates_.set_tool({});
        return;
    }
    if (code == 430) {
        if (block.has('H')) {
            whole_number('H', block.use('H'), 0, 99999, place);
        }
        moves_.warn("G43 takes a tool of length 0", place);
        return;
    }
    Point tool = coordinates_.modes().tool;
    if (code == 432 && block.has('H') == block.has_any(kAxisLetters)) {
        place.refuse("G43.2 wants either H or axis words");
    }
    for (int axis = 0; axis < kAxes; ++axis) {
        if (!block.has(kAxisLetters[axis])) continue;
        tool[axis] = coordinates_.number(block, axis) + (code == 432 ? tool[axis] : 0);
    }
    coordinates_.set_tool(tool);
}

}  // namespace curvecore::ref
