// SPDX-License-Identifier: Apache-2.0
// Modes, stops and the order within a block; interpreter_motion.cpp makes the moves.
#include "ref/gcode/interpreter/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

bool ends_program(int m_code) { return m_code == 2 || m_code == 30; }

}  // namespace

Interpreter::Interpreter(const std::string& file, double fit_tolerance,
                         ProgramParameters& parameters, const ProgramStart& start,
                         const CurveTable* table)
    : fit_tolerance_(fit_tolerance),
      parameters_(parameters),
      moves_(file),
      tools_(start.tools),
      parameter_unit_(start.unit),
      arc_tolerance_(start.arc_tolerance),
      table_(table) {
    begin(start);
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
    resolve_polar(block, codes, place);
    move(block, codes, place);
    use_leftovers(block, place);
    const std::optional<int> end = codes.of(Group::kStop);
    if (end) {
        check_nothing_waits(place);
        moves_.stop();
        if (!ends_program(*end)) moves_.leave_out(fmt::format("M{}", *end), place);
    }
    return !end || !ends_program(*end);
}

void Interpreter::note(const std::string& code, bool waits, const Place& place) {
    moves_.leave_out(code, place);
    if (waits) moves_.stop();
}

Program Interpreter::finish() {
    if (curve_) refuse_curve({moves_.file(), curve_->line});
    if (middle_ || nurbs_) {
        check_nothing_waits({moves_.file(), middle_ ? middle_->line : nurbs_->line});
    }
    return moves_.finish();
}

void Interpreter::set_feed(Block& block, const Codes& codes, const Place& place) {
    if (const std::optional<int> code = codes.of(Group::kFeedMode)) {
        const FeedMode mode = code == 930   ? FeedMode::kInverseTime
                              : code == 950 ? FeedMode::kPerTurn
                                            : FeedMode::kPerMinute;
        if (mode != modes_.feed_mode) modes_.feed.reset();
        modes_.feed_mode = mode;
    } else if (modes_.feed_mode == FeedMode::kInverseTime) {
        modes_.feed.reset();  // holds for one block
    }
    if (const std::optional<int> units = codes.of(Group::kUnits)) {
        coordinates_.set_inches(units == 200);
    }
    if (block.has('F')) {
        const double feed = block.use('F');
        if (feed < 0) {
            place.refuse(fmt::format("F must not be negative, but is {:g}", feed));
        }
        modes_.feed = feed;
        modes_.feed_unit = coordinates_.unit();
    }
}

void Interpreter::use_spindle_and_tool(Block& block, const Codes& codes, const Place& place) {
    if (block.has('S')) {
        const double speed = block.use('S');
        if (speed < 0) place.refuse("S must not be negative");
        modes_.speed = speed;
        moves_.leave_out("S", place, speed, true);
    }
    if (const std::optional<int> mode = codes.of(Group::kSpindleMode)) {
        modes_.surface_speed = mode == 960;
        if (modes_.surface_speed && block.has('D')) block.use('D');  // its limit
    }
    if (block.has('T')) {
        selected_tool_ = whole_number('T', block.use('T'), 0, kLargestTool, place);
        moves_.leave_out("T", place, selected_tool_);
    }
    for (const int code : block.m) {
        if (code == codes.of(Group::kStop)) continue;  // behind the block's move
        const bool analog = code == 67 || code == 68;
        const bool digital = code >= 62 && code <= 66;
        double value = 0;
        if (analog && block.has('Q')) value = block.use('Q');
        if (digital && block.has('P')) value = use_p(block, place);
        std::string named = fmt::format("M{}", code);
        if (analog && block.has('E')) {
            const double output = block.use('E');
            if (output != 0) named += fmt::format(" E{}", output);
        }
        moves_.leave_out(named, place, value, analog);
        if (!Codes::known(code)) moves_.warn(fmt::format("unknown code M{}", code), place);
    }
    if (const std::optional<int> spindle = codes.of(Group::kSpindle)) {
        modes_.turning = spindle == 3   ? Turning::kClockwise
                         : spindle == 4 ? Turning::kCounterClockwise
                                        : Turning::kNo;
    }
    if (codes.of(Group::kToolChange) == 6) {
        tool_ = selected_tool_;
    } else if (codes.of(Group::kToolChange)) {
        if (!block.has('Q')) place.refuse("M61 without Q (the tool)");
        tool_ = whole_number('Q', block.use('Q'), 0, kLargestTool, place);
    }
    if (codes.of(Group::kToolChange) || codes.of(Group::kSpindle)) {
        moves_.stop();
    }
}

/// Uses up the words of M codes that ask for more than motion.
void Interpreter::use_leftovers(Block& block, const Place& place) {
    const auto takes_words = [](int m) { return m == 19 || m == 61 || (m >= 50 && m != 60); };
    if (std::any_of(block.m.begin(), block.m.end(), takes_words)) {
        for (const char letter : std::string_view("DEHIJKLPQR")) block.use(letter);
    }
    block.check_all_used(place);
}

/// Reads P, which has many meanings, but only one in a block.
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
        modes_.normal_axis = plane == 170 ? 2 : plane == 180 ? 1 : 0;
    }
    if (const std::optional<int> diameter = codes.of(Group::kDiameter)) {
        coordinates_.set_diameter(diameter == 70);
    }
    if (const std::optional<int> code = codes.of(Group::kCompensation)) {
        compensation_ = *code;
        if (compensation_ != 400) check_radius(block, place);
    }
    if (const std::optional<int> length = codes.of(Group::kToolLength)) {
        set_tool_length(*length, block, place);
    }
    if (const std::optional<int> system = codes.of(Group::kSystem)) {
        select_system(*system);
    }
    if (const std::optional<int> control = codes.of(Group::kPathControl)) {
        set_path_control(*control, block, place);
    }
    if (const std::optional<int> distance = codes.of(Group::kDistance)) {
        coordinates_.set_absolute(distance == 900);
    }
    if (const std::optional<int> distance = codes.of(Group::kArcDistance)) {
        modes_.absolute_centre = distance == 901;
        centres_shown_ = true;
    }
    if (const std::optional<int> retract = codes.of(Group::kReturn)) {
        modes_.retract_to_r = retract == 990;
    }
}

void Interpreter::set_path_control(int control, Block& block, const Place& place) {
    modes_.exact_stop = control == 611;
    modes_.path_tolerance = control == 640 ? kPathTolerance : 0;
    if (control != 640) return;
    if (block.has('P')) {
        modes_.path_tolerance = use_p(block, place) * coordinates_.unit();
        if (modes_.path_tolerance < 0) place.refuse("P of G64 must not be negative");
        if (modes_.path_tolerance > kLargestTolerance ||
            (modes_.path_tolerance > 0 && modes_.path_tolerance < kSmallestTolerance)) {
            place.refuse(fmt::format("P of G64 is {:g} mm: 0 or {:g} .. {:g} mm",
                                     modes_.path_tolerance, kSmallestTolerance, kLargestTolerance));
        }
    }
    if (block.has('Q') && block.use('Q') < 0) {
        place.refuse("Q of G64 must not be negative");
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
