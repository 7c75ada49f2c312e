// SPDX-License-Identifier: Apache-2.0
// Modes, stops and the order within a block; the moves are made in interpreter_motion.cpp.
#include "ref/program/interpreter.hpp"

#include <fmt/format.h>

#include <cmath>

namespace curvecore::ref {
namespace {

bool ends_program(int m_code) { return m_code == 2 || m_code == 30; }

}  // namespace

Interpreter::Interpreter(const std::string& file, double fit_tolerance,
                         ProgramParameters& parameters)
    : fit_tolerance_(fit_tolerance), parameters_(parameters), moves_(file) {
    give_values();
}

bool Interpreter::execute(Block block, const Place& place) {
    if (block.empty()) {
        return true;
    }
    const Codes codes(block, place);
    if (middle_) {
        space_arc(block, codes, place);
        return true;
    }
    if (nurbs_) {
        nurbs_block(block, codes, place);
        return true;
    }
    set_feed(block, codes, place);
    use_spindle_and_tool(block, codes, place);
    const std::optional<int> action = codes.of(Group::kAction);
    if (action == 40) {
        dwell(block, place);
    }
    set_modes(block, codes, place);
    if (action && action != 40 && action != 530) {
        set_offsets(*action, block, codes, place);
    }
    move(block, codes, place);
    block.check_all_used(place);
    const std::optional<int> end = codes.of(Group::kStop);
    if (end) {
        check_nothing_waits(place);
        moves_.stop();
    }
    return !end || !ends_program(*end);
}

Program Interpreter::finish() {
    if (middle_ || nurbs_) {
        check_nothing_waits({moves_.file(), middle_ ? middle_->line : nurbs_->line});
    }
    return moves_.finish();
}

void Interpreter::set_feed(Block& block, const Codes& codes, const Place& place) {
    if (const std::optional<int> mode = codes.of(Group::kFeedMode)) {
        const bool inverse = mode == 930;
        if (inverse != inverse_time_) {
            feed_.reset();
        }
        inverse_time_ = inverse;
    } else if (inverse_time_) {
        feed_.reset();  // holds for one block
    }
    if (const std::optional<int> units = codes.of(Group::kUnits)) {
        coordinates_.set_inches(units == 200);
    }
    if (block.has('F')) {
        const double feed = block.use('F');
        if (feed < 0) {
            place.refuse(fmt::format("F must not be negative, but is {:g}", feed));
        }
        feed_ = feed;
        feed_unit_ = coordinates_.unit();
    }
}

void Interpreter::use_spindle_and_tool(Block& block, const Codes& codes, const Place& place) {
    if (block.has('S')) {
        const double speed = block.use('S');
        if (speed < 0) place.refuse("S must not be negative");
        moves_.leave_out("S", place, speed);
    }
    if (block.has('T')) {
        whole_number('T', block.use('T'), 0, 99999, place);
        moves_.leave_out("T", place);
    }
    for (const int code : block.m) {
        if (!ends_program(code)) moves_.leave_out(fmt::format("M{}", code), place);
    }
    if (codes.of(Group::kToolChange) || codes.of(Group::kSpindle)) {
        moves_.stop();
    }
}

/// P has many meanings; in one block it may have one.
double Interpreter::use_p(Block& block, const Place& place) {
    if (block.used('P')) {
        place.refuse("two codes of this block want P");
    }
    return block.use('P');
}

void Interpreter::dwell(Block& block, const Place& place) {
    if (!block.has('P')) {
        place.refuse("G4 without P (seconds)");
    }
    const double seconds = use_p(block, place);
    if (seconds < 0 || seconds > kLongestDwell) {
        place.refuse(
            fmt::format("P of G4 must be 0 to {:g} seconds, not {:g}", kLongestDwell, seconds));
    }
    moves_.dwell(seconds, place);
}

void Interpreter::set_modes(Block& block, const Codes& codes, const Place& place) {
    if (const std::optional<int> plane = codes.of(Group::kPlane)) {
        normal_axis_ = plane == 170 ? 2 : plane == 180 ? 1 : 0;
    }
    if (codes.of(Group::kToolLength) == 430) {
        if (block.has('H')) {
            whole_number('H', block.use('H'), 0, 99999, place);
        }
        moves_.warn("G43 takes a tool of length 0", place);
    }
    if (const std::optional<int> system = codes.of(Group::kSystem)) {
        coordinates_.select_system(*system);
    }
    if (const std::optional<int> control = codes.of(Group::kPathControl)) {
        set_path_control(*control, block, place);
    }
    if (const std::optional<int> distance = codes.of(Group::kDistance)) {
        coordinates_.set_absolute(distance == 900);
    }
    if (const std::optional<int> distance = codes.of(Group::kArcDistance)) {
        absolute_centre_ = distance == 901;
    }
}

void Interpreter::set_path_control(int control, Block& block, const Place& place) {
    exact_stop_ = control == 611;
    path_tolerance_ = control == 640 ? kPathTolerance : 0;
    if (control != 640) return;
    if (block.has('P')) {
        path_tolerance_ = use_p(block, place) * coordinates_.unit();
        if (path_tolerance_ < 0) place.refuse("P of G64 must not be negative");
        if (path_tolerance_ > kLargestTolerance ||
            (path_tolerance_ > 0 && path_tolerance_ < kSmallestTolerance)) {
            place.refuse(fmt::format("P of G64 is {:g} mm: 0 or {:g} .. {:g} mm", path_tolerance_,
                                     kSmallestTolerance, kLargestTolerance));
        }
    }
    if (block.has('Q') && block.use('Q') < 0) {
        place.refuse("Q of G64 must not be negative");
    }
}

void Interpreter::set_offsets(int action, Block& block, const Codes& codes, const Place& place) {
    const bool takes_axes = action == 100 || action == 920;
    const std::optional<int> motion = codes.of(Group::kMotion);
    if (takes_axes && motion && motion != 800) {
        place.refuse(fmt::format("{} and {} both want the axis words of this block", g_name(action),
                                 g_name(*motion)));
    }
    if (takes_axes && !block.has_any(kAxisLetters)) {
        place.refuse(fmt::format("{} without axis words", g_name(action)));
    }
    switch (action) {
        case 100:
            if (!block.has('L') || block.use('L') != 2) {
                place.refuse("of G10 only L2 is supported");
            }
            if (!block.has('P')) {
                place.refuse("G10 L2 without P (1 is G54, 0 the system in force)");
            }
            if (block.has('R') && block.use('R') != 0) {
                place.refuse("a rotation (R of G10 L2) is not supported");
            }
            coordinates_.set_offset(whole_number('P', use_p(block, place), 0, 9, place), block,
                                    place);
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

void Interpreter::check_nothing_waits(const Place& place) const {
    if (middle_) {
        place.refuse(fmt::format("the arc begun in line {} lacks the block with its end point",
                                 middle_->line));
    }
    if (nurbs_) {
        place.refuse(fmt::format("the NURBS begun in line {} lacks its G5.3", nurbs_->line));
    }
}

}  // namespace curvecore::ref
