// SPDX-License-Identifier: Apache-2.0
// The interpreter's moves: lines, arcs in the three planes, arcs through three points, feeds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ref/gcode/cycles/thread_cycles.hpp"
#include "ref/gcode/interpreter/interpreter.hpp"
#include "ref/moves/asked_arc.hpp"

namespace curvecore::ref {
namespace {

constexpr std::string_view kOffsetLetters = "IJK";

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

Aux aux(const Point& point) { return {point[3], point[4], point[5], point[6], point[7], point[8]}; }

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
    if (motion_ == kNoMotion) {
        place.refuse("axis words, but no motion code (G0 G1 G2 G3) is in force");
    }
    if (!is_canned_cycle(motion_)) canned_cycles_.end_row();
    if (is_canned_cycle(motion_) || is_thread(motion_)) {
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
    move.aux_start = aux(coordinates_.position());
    move.aux_end = aux(target);
    move.exact_stop = modes_.exact_stop;
    move.tolerance = modes_.path_tolerance;
    return move;
}

void Interpreter::arc(Block& block, const Place& place) {
    const int first = (modes_.normal_axis + 1) % 3;
    const int second = (modes_.normal_axis + 2) % 3;
    const bool clockwise = motion_ == 20;
    const bool has_end = block.has(kAxisLetters[first]) || block.has(kAxisLetters[second]);
    const Point target = coordinates_.target(block, false, place);
    Move move = move_to(target, place);
    move.start = coordinates_.turned_back(move.start);
    move.end = coordinates_.turned_back(move.end);
    const Eigen::Vector2d start(move.start[first], move.start[second]);
    const Eigen::Vector2d end(move.end[first], move.end[second]);
    PlaneArc found{};
    AskedArc asked{move.start, move.end, move.start,
                   Vec3::Unit(modes_.normal_axis) * (clockwise ? -1 : 1), 1};
    int& turns = asked.turns;
    if (block.has('P')) {
        turns = whole_number('P', use_p(block, place), 1, kMostTurns, place);
    }
    try {
        if (block.has('R')) {
            if (block.has_any(kOffsetLetters)) {
                place.refuse("R and a centre (I, J, K) in one block: give one of them");
            }
            if (!has_end) {
                place.refuse(fmt::format("{} with R lacks its end point", g_name(motion_)));
            }
            const double radius = block.use('R') * coordinates_.unit();
            found = arc_with_radius(start, end, radius, clockwise, turns, arc_tolerance());
            asked = AskedArc::of_radius(move.start, move.end, radius, asked.normal, turns);
        } else {
            const Eigen::Vector2d centre = plane_centre(block, start, place);
            check_radii(start, end, centre, place);
            found = arc_with_centre(start, end, centre, clockwise, turns, arc_tolerance());
            asked.centre[first] = centre.x();
            asked.centre[second] = centre.y();
        }
    } catch (const ArcError& error) {
        place.refuse(error.what());
    }
    move.kind = Move::Kind::kArc;
    move.angle = found.angle;
    move.normal = asked.normal;
    move.centre = move.start;
    move.centre[first] = found.centre.x();
    move.centre[second] = found.centre.y();
    move.advance = move.end - move.start;
    move.advance[first] = found.drift.x();
    move.advance[second] = found.drift.y();
    move.deviation = distance(asked, move);
    move.start = xyz(coordinates_.position());
    move.end = xyz(target);
    for (Vec3* vector : {&move.centre, &move.normal, &move.advance}) {
        *vector = coordinates_.turned(*vector);
    }
    add(move, target, place);
}

ArcTolerance Interpreter::arc_tolerance() const {
    ArcTolerance tolerance = coordinates_.inches() ? kArcToleranceInch : kArcToleranceMm;
    if (arc_tolerance_) tolerance.always = tolerance.most = *arc_tolerance_;
    return tolerance;
}

/// Refuses a centre that does not fit both ends, and names one that does.
void Interpreter::check_radii(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                              const Eigen::Vector2d& centre, const Place& place) const {
    const ArcTolerance tolerance = arc_tolerance();
    const auto fits = [&](const Eigen::Vector2d& point) {
        return tolerance.holds((start - point).norm(), (end - point).norm());
    };
    if (fits(centre) || centre == start || centre == end) return;
    const Eigen::Vector2d chord = (end - start).normalized();
    const Eigen::Vector2d nearest = centre - chord * chord.dot(centre - (start + end) / 2);
    const std::array<int, 2> axes = {(modes_.normal_axis + 1) % 3, (modes_.normal_axis + 2) % 3};
    std::string words;
    Eigen::Vector2d as_absolute;
    for (int i = 0; i < 2; ++i) {
        const double zero = coordinates_.absolute_centre(axes[i], 0);
        const double from = modes_.absolute_centre ? zero : start[i];
        words += fmt::format(" {}{:.6g}", kOffsetLetters[axes[i]],
                             (nearest[i] - from) / coordinates_.unit());
        as_absolute[i] = centre[i] - start[i] + zero;
    }
    const bool g90_1 = !modes_.absolute_centre && fits(as_absolute);
    place.refuse(
        fmt::format("the arc's radii differ: {:.6g} mm at the start, {:.6g} mm at the end; {}"
                    "--arc-tolerance allows more than {:.3g} mm",
                    (start - centre).norm(), (end - centre).norm(),
                    g90_1 ? "as absolute ones (G90.1) these centre words fit; "
                          : fmt::format("the centre{} would fit; ", words),
                    tolerance.always));
}

Eigen::Vector2d Interpreter::plane_centre(Block& block, const Eigen::Vector2d& start,
                                          const Place& place) const {
    const std::array<int, 2> axes = {(modes_.normal_axis + 1) % 3, (modes_.normal_axis + 2) % 3};
    const std::array<char, 2> letters = {kOffsetLetters[axes[0]], kOffsetLetters[axes[1]]};
    const int given = int{block.has(letters[0])} + int{block.has(letters[1])};
    const char beside = kOffsetLetters[modes_.normal_axis];  // 0 as some posts write it
    if (block.has(beside) && block.use(beside) != 0) {
        place.refuse(fmt::format("{} with an arc in the {}{} plane", beside, kAxisLetters[axes[0]],
                                 kAxisLetters[axes[1]]));
    }
    if (given == 0) {
        place.refuse(fmt::format("{} without a centre ({}, {}) or a radius (R)", g_name(motion_),
                                 letters[0], letters[1]));
    }
    if (modes_.absolute_centre && given == 1) {
        place.refuse(fmt::format("G90.1 wants both {} and {}", letters[0], letters[1]));
    }
    Eigen::Vector2d centre = start;
    for (int i = 0; i < 2; ++i) {
        if (block.has(letters[i])) {
            const double number = block.use(letters[i]);
            centre[i] = modes_.absolute_centre ? coordinates_.absolute_centre(axes[i], number)
                                               : start[i] + number * coordinates_.unit();
        }
    }
    return centre;
}

void Interpreter::space_arc(Block& block, const Codes& codes, const Place& place) {
    const std::optional<int> code = codes.of(Group::kMotion);
    if (block.g.size() > (code == motion_ ? 1 : 0) || !block.m.empty() ||
        !block.has_any(kAxisLetters)) {
        check_nothing_waits(place);
    }
    if (block.has('F')) {
        set_feed(block, codes, place);
    } else {
        modes_.feed = middle_->feed;
    }
    const Point target = coordinates_.target(block, false, place);
    coordinates_.set_position(middle_->start);
    Move move = move_to(target, place);
    move.kind = Move::Kind::kArc;
    try {
        const SpaceArc found = arc_through(move.start, middle_->point, move.end);
        move.centre = found.centre;
        move.normal = found.normal;
        move.angle = found.angle;
    } catch (const ArcError& error) {
        place.refuse(error.what());
    }
    middle_.reset();
    add(move, target, place);
    block.check_all_used(place);
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
                         : fmt::format("{} without a feed: no F yet", g_name(motion_)));
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
