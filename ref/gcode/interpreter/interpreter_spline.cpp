// SPDX-License-Identifier: Apache-2.0
// The interpreter's splines, as in LinuxCNC: G5 (cubic), G5.1 (quadratic) and the NURBS of G5.2 ..
// G5.3, all in the XY plane. Our extensions: G5 and G5.2 in space, with Z at every point, and K
// beside I J, R beside P Q.
//
// I J and P Q are offsets also with G90.1. With G91 the control points of a NURBS count from its
// start, where the machine still stands. Its weights (P) are 1 and its order (L) is 3 unless given.
// Its knots are LinuxCNC's, or those of K, our extension: one of them in each block from G5.2 on,
// and the rest in blocks of K alone behind the last point, as in Fanuc's G06.2.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/gcode/interpreter/interpreter.hpp"

namespace curvecore::ref {
namespace {

constexpr int kUsualOrder = 3;

}  // namespace

void Interpreter::check_spline(Block& block, const Place& place) {
    if (modes_.normal_axis != 2) {
        place.refuse(fmt::format("{} wants the XY plane (G17)", g_name(motion_)));
    }
    const bool flat = motion_ == 51;
    if (block.has_any(flat ? "ZABCUVW" : "ABCUVW")) {
        place.refuse(fmt::format("{} takes the axes X{} only", g_name(motion_),
                                 flat ? " and Y" : ", Y and Z"));
    }
    if (block.has_any(motion_ == 50 ? "ZKR" : "Z")) {
        moves_.warn(
            fmt::format("{} in space (Z, K, R) is this reader's own: elsewhere it lies in the XY "
                        "plane",
                        g_name(motion_)),
            place);
    }
}

void Interpreter::spline(Block& block, const Place& place) {
    check_spline(block, place);
    const Point target = coordinates_.target(block, false, place);
    const Vec3 start = xyz(coordinates_.position());
    const Vec3 end = xyz(target);
    const Bezier points = motion_ == 50 ? cubic_legs(block, start, end, place)
                                        : quadratic_legs(block, start, end, place);
    for (const Vec3& point : points) {
        if (!(point.cwiseAbs().maxCoeff() <= kFarthest)) {
            place.refuse(
                fmt::format("a control point is out of range: beyond {:.10g} mm", kFarthest));
        }
    }
    add_curve({from_bezier(points)}, target, place);
}

Bezier Interpreter::cubic_legs(Block& block, const Vec3& start, const Vec3& end,
                               const Place& place) {
    const double unit = coordinates_.unit();
    if (!block.has('P') || !block.has('Q')) {
        place.refuse("G5 wants both P and Q, from the end to the second control point");
    }
    if (block.has('I') != block.has('J')) {
        place.refuse("G5 with only one of I and J: give both, or neither behind another G5");
    }
    Vec3 out = Vec3::Zero();
    if (block.has('I')) {
        out.x() = block.use('I') * unit;
        out.y() = block.use('J') * unit;
        if (block.has('K')) out.z() = block.use('K') * unit;
    } else if (last_leg_) {
        out = -*last_leg_;
    } else {
        place.refuse("the first G5 behind another motion wants I and J");
    }
    const double p = use_p(block, place) * unit;
    last_leg_ = Vec3(p, block.use('Q') * unit, block.has('R') ? block.use('R') * unit : 0);
    return {start, start + coordinates_.turned(out), end + coordinates_.turned(*last_leg_), end};
}

Bezier Interpreter::quadratic_legs(Block& block, const Vec3& start, const Vec3& end,
                                   const Place& place) const {
    Vec3 out = Vec3::Zero();
    for (const int axis : {0, 1}) {
        if (block.has("IJ"[axis])) {
            out[axis] = block.use("IJ"[axis]) * coordinates_.unit();
        }
    }
    if (out.isZero(0)) {
        place.refuse("G5.1 wants I and J, from the start to the control point, not both 0");
    }
    const Vec3 middle = start + coordinates_.turned(out);
    return {start, start + 2 * out / 3, end + 2 * (middle - end) / 3, end};
}

void Interpreter::open_nurbs(Block& block, const Place& place) {
    check_spline(block, place);
    OpenNurbs open{};
    open.last = coordinates_.position();
    open.curve.points = {xyz(open.last)};
    open.curve.weights = {1};
    open.feed = modes_.feed;
    open.line = place.program_line;
    nurbs_ = std::move(open);
    control_point(block, place);
}

void Interpreter::nurbs_block(Block& block, const Codes& codes, const Place& place) {
    const std::optional<int> code = codes.of(Group::kMotion);
    if (block.g.size() > (code == 52 || code == 53 ? 1 : 0) || !block.m.empty()) {
        check_nothing_waits(place);
    }
    if (block.has('F')) {
        set_feed(block, codes, place);
        nurbs_->feed = modes_.feed;
    }
    if (code == 53) {
        close_nurbs(place);
    } else {
        check_spline(block, place);
        control_point(block, place);
    }
    block.check_all_used(place);
}

void Interpreter::control_point(Block& block, const Place& place) {
    Nurbs& curve = nurbs_->curve;
    if (block.has('L')) {
        const int order = whole_number('L', block.use('L'), 2, kHighestOrder, place);
        if (nurbs_->order && *nurbs_->order != order) {
            place.refuse(fmt::format("L{} where this NURBS has L{}", order, *nurbs_->order));
        }
        nurbs_->order = order;
    }
    if (block.has('X') != block.has('Y')) {
        place.refuse("a control point wants both X and Y");
    }
    double weight = 1;
    if (block.has('P')) {
        weight = use_p(block, place);
        if (!(weight > 0)) {
            place.refuse(fmt::format("the weight P must be above 0, not {:g}", weight));
        }
    }
    if (block.has('K')) curve.knots.push_back(block.use('K'));
    if (block.has('X')) {
        nurbs_->last = coordinates_.target(block, false, place);
        curve.points.push_back(xyz(nurbs_->last));
        curve.weights.push_back(weight);
    } else if (block.has('P')) {
        if (curve.points.size() > 1) {
            place.refuse("P without X and Y is the weight of the curve's start: it comes first");
        }
        curve.weights[0] = weight;
    }
}

void Interpreter::close_nurbs(const Place& place) {
    OpenNurbs open = std::move(*nurbs_);
    nurbs_.reset();
    const int count = static_cast<int>(open.curve.points.size());
    open.curve.order = open.order.value_or(kUsualOrder);
    if (count < open.curve.order) {
        place.refuse(
            fmt::format("the NURBS begun in line {} has too few control points: {}, L{} wants "
                        "{}",
                        open.line, count, open.curve.order, open.curve.order));
    }
    if (!open.curve.knots.empty()) {
        const std::string why = why_no_knots(open.curve);
        if (!why.empty()) {
            place.refuse(fmt::format("the NURBS begun in line {} has {}", open.line, why));
        }
    }
    modes_.feed = open.feed;
    add_curve(cubics_of(open.curve, fit_tolerance_), open.last, place);
    motion_ = kNoMotion;
}

void Interpreter::add_curve(const std::vector<Cubic>& cubics, const Point& target,
                            const Place& place) {
    std::vector<Move> pieces = moves_.pieces_of(cubics, move_to(target, place), place);
    double length = 0;
    for (const Move& piece : pieces) length += piece.length();
    const double feed = feed_on(pieces.back(), length, place);
    for (Move& piece : pieces) {
        piece.feed = feed;
        moves_.append(piece);
    }
    coordinates_.set_position(target);
}

}  // namespace curvecore::ref
