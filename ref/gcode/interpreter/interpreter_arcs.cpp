// SPDX-License-Identifier: Apache-2.0
// The interpreter's arcs: in the three planes by centre or radius, and through three points.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "ref/gcode/interpreter/interpreter.hpp"
#include "ref/moves/asked_arc.hpp"

namespace curvecore::ref {
namespace {

constexpr std::string_view kCentreLetters = "IJK";

}  // namespace

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
            if (block.has_any(kCentreLetters)) {
                place.refuse("R and a centre (I, J, K) in one block: give one of them");
            }
            if (!has_end) {
                place.refuse(fmt::format("{} with R lacks its end point", g_name(motion_)));
            }
            const double radius = block.use('R') * coordinates_.unit();
            found = arc_with_radius(start, end, radius, clockwise, turns, arc_tolerance());
            asked = AskedArc::of_radius(move.start, move.end, radius, asked.normal, turns);
        } else {
            const Eigen::Vector2d centre =
                fitted_centre(start, end, plane_centre(block, start, place), place);
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

/// Returns the centre, if it fits both ends. Words that fit as absolute ones alone are read as
/// that, unless the program has shown what its words are; others are refused, with a centre that
/// fits.
Eigen::Vector2d Interpreter::fitted_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                                           const Eigen::Vector2d& centre, const Place& place) {
    const ArcTolerance tolerance = arc_tolerance();
    const auto fits = [&](const Eigen::Vector2d& point) {
        return tolerance.holds((start - point).norm(), (end - point).norm());
    };
    const std::array<int, 2> axes = {(modes_.normal_axis + 1) % 3, (modes_.normal_axis + 2) % 3};
    const Eigen::Vector2d zero(coordinates_.absolute_centre(axes[0], 0),
                               coordinates_.absolute_centre(axes[1], 0));
    Eigen::Vector2d absolute = centre - start + zero;
    const bool g90_1 = !modes_.absolute_centre && fits(absolute);
    if (fits(centre) || centre == start || centre == end) {
        centres_shown_ = centres_shown_ || !g90_1;
        return centre;
    }
    if (g90_1 && !centres_shown_) {
        moves_.warn(
            "the program's centre words fit as absolute ones alone: they are read as in "
            "G90.1, which LinuxCNC wants in the program",
            place);
        centres_shown_ = modes_.absolute_centre = true;
        return absolute;
    }
    const Eigen::Vector2d chord = (end - start).normalized();
    const Eigen::Vector2d nearest = centre - chord * chord.dot(centre - (start + end) / 2);
    std::string words;
    for (int i = 0; i < 2; ++i) {
        const double from = modes_.absolute_centre ? zero[i] : start[i];
        words += fmt::format(" {}{:.6g}", kCentreLetters[axes[i]],
                             (nearest[i] - from) / coordinates_.unit());
    }
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
    const std::array<char, 2> letters = {kCentreLetters[axes[0]], kCentreLetters[axes[1]]};
    const int given = int{block.has(letters[0])} + int{block.has(letters[1])};
    const char beside = kCentreLetters[modes_.normal_axis];  // 0 as some posts write it
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

}  // namespace curvecore::ref
