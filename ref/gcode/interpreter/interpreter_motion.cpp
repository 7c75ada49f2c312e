// SPDX-License-Identifier: Apache-2.0
// The interpreter's moves: which one a block asks for, lines, feeds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ref/gcode/cycles/thread_cycles.hpp"
#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {
namespace {

bool is_arc(int motion) { return motion == 20 || motion == 30; }
bool is_space_arc(int motion) { return motion == 24 || motion == 34; }
bool is_spline(int motion) { return motion == 50 || motion == 51; }
constexpr int kProbedX = 5061;  // .. 5069
constexpr int kProbeTripped = 5070;

bool is_probing(int motion) { return motion >= 382 && motion <= 385; }

/// Returns true for Fanuc's look-ahead codes G5 P.. and G5.1 Q..
bool is_look_ahead(Block& block, int code) {
    if (!is_spline(code) || block.has_any("XYZABCUVWIJK")) return false;
    const char letter = code == 50 ? 'P' : 'Q';
    if (!block.has(letter)) return false;
    block.use(letter);
    return true;
}

}  // namespace

void Interpreter::move(Block& block, const Codes& codes, const Place& place) {
    const std::optional<int> code = codes.of(Group::kMotion);
    const std::optional<int> action = codes.of(Group::kAction);
    if (code && is_look_ahead(block, *code)) {
        moves_.warn(fmt::format("{} asks for looking ahead, which is done anyway", g_name(*code)),
                    place);
        return;
    }
    const bool again = code.value_or(motion_) == motion_;
    motion_ = code.value_or(motion_);
    motion_said_ = motion_said_ || code;
    if (motion_ != 50) {
        last_leg_.reset();
    }
    const bool machine = action == 530;
    const std::optional<int> length = codes.of(Group::kToolLength);
    const bool axes_taken =
        (action && takes_axes(*action)) || (!code && (length == 431 || length == 432));
    const bool wants_motion =
        !axes_taken && (block.has_any(kAxisLetters) || (is_arc(motion_) && block.has_any("IJKR")));
    if (machine && motion_ != 0 && motion_ != 10) {
        place.refuse("G53 goes with G0 and G1 only");
    }
    if (machine && !coordinates_.absolute()) {
        place.refuse("G53 and G91 exclude each other");
    }
    if (machine && !wants_motion) {
        place.refuse("G53 without axis words");
    }
    if (code == 52) {
        open_nurbs(block, place);
        return;
    }
    if (code == 53) {
        place.refuse("G5.3 without a G5.2");
    }
    if (!wants_motion) {
        if (code && is_arc(*code)) {
            place.refuse(fmt::format("{} without an end point or a centre", g_name(*code)));
        }
        if (code && is_spline(*code)) {
            place.refuse(fmt::format("{} without an end point (X, Y)", g_name(*code)));
        }
        if (code && *code >= 330 && *code != kNoMotion) {
            place.refuse(fmt::format("{} without axis words", g_name(*code)));
        }
        return;
    }
    if (motion_ == kNoMotion) take_rapid(place);
    const bool turns_count = modes_.feed_mode == FeedMode::kPerTurn || is_thread(motion_);
    if (modes_.surface_speed && turns_count && motion_ != 0) {
        moves_.warn(
            "feeds per turn are not exact in G96: S, a speed of the surface, is taken as "
            "turns a minute; G97 S names those",
            place);
    }
    if (!is_canned_cycle(motion_)) canned_cycles_.end_row();
    if (curve_) {
        table_curve(block, place);
    } else if (is_canned_cycle(motion_) || is_thread(motion_)) {
        cycle(again, block, place);
    } else if (is_arc(motion_)) {
        arc(block, place);
    } else if (is_spline(motion_)) {
        spline(block, place);
    } else if (is_space_arc(motion_)) {
        if (block.has_any("ABCUVW")) {
            place.refuse("the intermediate point of an arc takes X, Y and Z only");
        }
        const Point point = coordinates_.target(block, false, place);
        middle_ = Middle{coordinates_.position(), xyz(point), place.program_line, modes_.feed};
        coordinates_.set_position(point);
    } else {
        line(coordinates_.target(block, machine, place), motion_ == 0, place);
        if (is_probing(motion_)) {
            moves_.warn("a probing move is drawn to its end", place);
            moves_.stop();
            for (int axis = 0; axis < kMachineAxes; ++axis) {
                parameters_.set(kProbedX + axis, coordinates_.programmed(axis));
            }
            parameters_.set(kProbeTripped, 0);
        }
    }
}

/// Begins with G0 where no motion is in force, as grbl and Fanuc's controls do.
void Interpreter::take_rapid(const Place& place) {
    if (motion_said_) {
        place.refuse("axis words, but no motion code (G0 G1 G2 G3) is in force");
    }
    moves_.warn("axis words before any motion code are G0's, as grbl begins; LinuxCNC refuses them",
                place);
    motion_ = 0;
}

void Interpreter::line(const Point& target, bool rapid, const Place& place) {
    Move move = move_to(target, place);
    move.rapid = rapid;
    add(move, target, place);
}

Move Interpreter::move_to(const Point& target, const Place& place) const {
    Move move;
    move.line = place.program_line;
    move.start = xyz(coordinates_.position());
    move.end = xyz(target);
    move.aux_start = aux_of(coordinates_.position());
    move.aux_end = aux_of(target);
    move.exact_stop = modes_.exact_stop;
    move.tolerance = modes_.path_tolerance;
    return move;
}

void Interpreter::add(Move move, const Point& target, const Place& place) {
    if (!moves_.moves(move, place)) return;
    if (!move.rapid && move.feed == 0) move.feed = feed_on(move, move.length(), place);
    moves_.append(move);
    coordinates_.set_position(target);
}

double Interpreter::feed_on(const Move& move, double length, const Place& place) const {
    const bool inverse_time = modes_.feed_mode == FeedMode::kInverseTime;
    if (!modes_.feed) {
        place.refuse(inverse_time
                         ? fmt::format("{} in G93 wants an F in its own block", g_name(motion_))
                         : fmt::format("{} without a feed: no F yet; give one before it, or by "
                                       "RS274NGC_STARTUP_CODE of the machine's .ini",
                                       g_name(motion_)));
    }
    double feed = *modes_.feed;
    if (feed == 0) {
        place.refuse(fmt::format("{} with a feed of 0", g_name(motion_)));
    }
    if (inverse_time) return feed_of(feed * length, place);
    if (modes_.feed_mode == FeedMode::kPerTurn) {
        if (modes_.speed == 0) {
            place.refuse(
                fmt::format("{} in G95: F is per turn of the spindle, whose speed is 0: give S",
                            g_name(motion_)));
        }
        feed *= modes_.speed;
    }
    const auto still = [&move](int axis) { return move.aux_end[axis] == move.aux_start[axis]; };
    const bool degrees = move.kind == Move::Kind::kLine && move.start == move.end && still(3) &&
                         still(4) && still(5);
    return feed_of(degrees ? feed : feed * modes_.feed_unit, place);
}

}  // namespace curvecore::ref
