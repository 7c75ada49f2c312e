// SPDX-License-Identifier: Apache-2.0
// The interpreter's moves: lines, arcs in the three planes, arcs through three points, feeds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ref/program/asked_arc.hpp"
#include "ref/program/interpreter.hpp"

namespace curvecore::ref {
namespace {

constexpr std::string_view kOffsetLetters = "IJK";

bool is_arc(int motion) { return motion == 20 || motion == 30; }
bool is_space_arc(int motion) { return motion == 24 || motion == 34; }
bool is_spline(int motion) { return motion == 50 || motion == 51; }

Aux aux(const Point& point) { return {point[3], point[4], point[5], point[6], point[7], point[8]}; }

}  // namespace

void Interpreter::move(Block& block, const Codes& codes, const Place& place) {
    const std::optional<int> code = codes.of(Group::kMotion);
    motion_ = code.value_or(motion_);
    if (motion_ != 50) {
        last_leg_.reset();
    }
    const std::optional<int> action = codes.of(Group::kAction);
    const bool machine = action == 530;
    const bool axes_taken = action == 100 || action == 920;
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
        return;
    }
    if (motion_ == 800) {
        place.refuse("axis words, but no motion code (G0 G1 G2 G3) is in force");
    }
    if (is_arc(motion_)) {
        arc(block, place);
    } else if (is_spline(motion_)) {
        spline(block, place);
    } else if (is_space_arc(motion_)) {
        if (block.has_any("ABCUVW")) {
            place.refuse("the intermediate point of an arc takes X, Y and Z only");
        }
        const Point point = coordinates_.target(block, false, place);
        middle_ = Middle{coordinates_.position(), xyz(point), place.line, feed_};
        coordinates_.set_position(point);
    } else {
        const Point target = coordinates_.target(block, machine, place);
        add(move_to(target, place), target, place);
    }
}

Move Interpreter::move_to(const Point& target, const Place& place) const {
    Move move;
    move.line = place.line;
    move.rapid = motion_ == 0;
    move.start = xyz(coordinates_.position());
    move.end = xyz(target);
    move.aux_start = aux(coordinates_.position());
    move.aux_end = aux(target);
    move.exact_stop = exact_stop_;
    move.tolerance = path_tolerance_;
    return move;
}

void Interpreter::arc(Block& block, const Place& place) {
    const int first = (normal_axis_ + 1) % 3;
    const int second = (normal_axis_ + 2) % 3;
    const bool clockwise = motion_ == 20;
    const bool has_end = block.has(kAxisLetters[first]) || block.has(kAxisLetters[second]);
    const Point target = coordinates_.target(block, false, place);
    Move move = move_to(target, place);
    const Eigen::Vector2d start(move.start[first], move.start[second]);
    const Eigen::Vector2d end(move.end[first], move.end[second]);
    PlaneArc found{};
    AskedArc asked{move.start, move.end, move.start,
                   Vec3::Unit(normal_axis_) * (clockwise ? -1 : 1), 1};
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
    add(move, target, place);
}

Eigen::Vector2d Interpreter::plane_centre(Block& block, const Eigen::Vector2d& start,
                                          const Place& place) const {
    const std::array<int, 2> axes = {(normal_axis_ + 1) % 3, (normal_axis_ + 2) % 3};
    const std::array<char, 2> letters = {kOffsetLetters[axes[0]], kOffsetLetters[axes[1]]};
    const int given = int{block.has(letters[0])} + int{block.has(letters[1])};
    if (block.has(kOffsetLetters[normal_axis_])) {
        place.refuse(fmt::format("{} with an arc in the {}{} plane", kOffsetLetters[normal_axis_],
                                 kAxisLetters[axes[0]], kAxisLetters[axes[1]]));
    }
    if (given == 0) {
        place.refuse(fmt::format("{} without a centre ({}, {}) or a radius (R)", g_name(motion_),
                                 letters[0], letters[1]));
    }
    if (absolute_centre_ && given == 1) {
        place.refuse(fmt::format("G90.1 wants both {} and {}", letters[0], letters[1]));
    }
    Eigen::Vector2d centre = start;
    for (int i = 0; i < 2; ++i) {
        if (block.has(letters[i])) {
            const double number = block.use(letters[i]);
            centre[i] = absolute_centre_ ? coordinates_.absolute_centre(axes[i], number)
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
        feed_ = middle_->feed;
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
    move.feed = move.rapid ? 0 : feed_on(move, move.length(), place);
    moves_.append(move);
    coordinates_.set_position(target);
}

double Interpreter::feed_on(const Move& move, double length, const Place& place) const {
    if (!feed_) {
        place.refuse(inverse_time_
                         ? fmt::format("{} in G93 wants an F in its own block", g_name(motion_))
                         : fmt::format("{} without a feed: no F yet", g_name(motion_)));
    }
    if (*feed_ == 0) {
        place.refuse(fmt::format("{} with a feed of 0", g_name(motion_)));
    }
    const auto still = [&move](int axis) { return move.aux_end[axis] == move.aux_start[axis]; };
    const bool degrees = move.kind == Move::Kind::kLine && move.start == move.end && still(3) &&
                         still(4) && still(5);
    const double per_minute = inverse_time_ ? *feed_ * length
                              : degrees     ? *feed_
                                            : *feed_ * feed_unit_;
    return feed_of(per_minute, place);
}

}  // namespace curvecore::ref
