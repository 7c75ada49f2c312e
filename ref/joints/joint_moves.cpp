// SPDX-License-Identifier: Apache-2.0
#include "ref/joints/joint_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ref/limits/path_shape.hpp"
#include "ref/limits/travel.hpp"
#include "ref/numeric/angles.hpp"
#include "ref/segment/series_error.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kShortest = 1e-4;   // mm of the tool's path, of a piece within a move
constexpr double kNoLength = 1e-12;  // mm

template <class Number>
Joints<Number> joints_of(const Kinematics& kinematics, const ToolPose<Number>& tool) {
    return std::visit([&](const auto& machine) { return machine.joints(tool); }, kinematics);
}

template <int Orders>
VectorSeries<Orders> first_orders(const VectorSeries<kToolOrders>& of, int orders) {
    VectorSeries<Orders> first;
    for (int n = 0; n <= std::min(orders, Orders); ++n) first.c.col(n) = of.c.col(n);
    return first;
}

}  // namespace

JointMoves::JointMoves(MoveSource source, std::string file, const Machine& machine,
                       const PlanOptions& options)
    : source_(std::move(source)),
      file_(std::move(file)),
      machine_(machine),
      tool_(machine.of_tool()),
      orders_(std::min(options.format.order, kJointOrders)),
      tolerance_(kJointShare * options.error_limit * options.unit_mm),
      stretch_(machine.joint_stretch()) {
    const int k = longest_series_step(options.format, kWordShare * options.error_limit);
    if (k < 0) {
        throw InputError(file_, 0,
                         fmt::format("the words of this core draw no joints within {:g} units: "
                                     "take a larger CoefBits",
                                     options.error_limit));
    }
    longest_ = std::ldexp(options.unit_mm, k) / stretch_;
}

bool JointMoves::next(Move& piece) {
    while (done_ >= length_) {
        if (!source_(move_)) return false;
        length_ = move_.length();
        done_ = 0;
        check_travel();
        check_letters();
        if (!last_) begin();
        if (length_ > kNoLength) break;
        length_ = 0;
        // A move without a way: its stop is asked for where the joints are.
        piece = move_;
        piece.kind = Move::Kind::kLine;
        piece.start = piece.end = *last_;
        return true;
    }
    const Reach reach = longest_from(done_);
    const double rest = length_ - done_;
    double length = reach.length;
    if (length < rest) length = rest / std::ceil(rest / length);
    if (length >= rest * (1 - 1e-12)) length = rest;
    piece = piece_of(reach, length);
    done_ = length == rest ? length_ : done_ + length;
    last_ = piece.end;
    return true;
}

void JointMoves::refuse(const std::string& reason) const {
    throw InputError(file_, move_.line, reason);
}

void JointMoves::check_travel() const {
    const std::string beyond = beyond_travel(travel(move_), move_, tool_);
    if (!beyond.empty()) refuse(beyond);
}

/// Sets the joints that the program begins with: home, if it begins there.
void JointMoves::begin() {
    constexpr double kSame = 1e-6;  // mm, degrees
    const auto [x, y, z] = tool_at(move_, length_, 0).xyz;
    if (tool_.home && (Vec3(x, y, z) - *tool_.home).norm() < kSame) last_ = machine_.home;
    const Vec3 joints = joints_at(0);
    if (!joints.allFinite()) out_of_reach(0);
    if (last_ && (joints - *last_).norm() > kSame) {
        refuse(fmt::format(
            "{}: HOME of the joints is {:.6g} {:.6g} {:.6g}, and the kinematics put "
            "its tool there by {:.6g} {:.6g} {:.6g}",
            machine_.name, (*last_)[0], (*last_)[1], (*last_)[2], joints[0], joints[1], joints[2]));
    }
    last_ = joints;
}

/// Checks that each letter that moves is one that the kinematics have as a joint.
void JointMoves::check_letters() const {
    const std::string_view undriven =
        std::visit([](const auto& machine) { return machine.kUndriven; }, machine_.kinematics);
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        const char letter = kAxisLetters[3 + i];
        if (move_.aux_start[i] == move_.aux_end[i]) continue;
        if (undriven.find(letter) == std::string_view::npos) continue;
        refuse(fmt::format("{}: {} has no joint for it", letter, name_of(machine_.kinematics)));
    }
}

void JointMoves::out_of_reach(double s) const {
    const auto [x, y, z] = tool_at(move_, length_, s).xyz;
    refuse(fmt::format("the joints of {} ({}) do not reach X{:.4f} Y{:.4f} Z{:.4f}{}",
                       machine_.name, name_of(machine_.kinematics), x, y, z,
                       last_ || machine_.home ? ""
                                              : ", where the program begins without HOME in "
                                                "[JOINT_0] .. [JOINT_2]"));
}

/// Lets the joints that turn go on from where they are.
void JointMoves::go_on(Vec3& joints) const {
    const std::array<bool, 3> turns = turning(machine_.kinematics);
    for (int i = 0; i < 3; ++i) {
        if (!turns[static_cast<std::size_t>(i)] || !last_) continue;
        joints[i] += kTurnDegrees * std::round(((*last_)[i] - joints[i]) / kTurnDegrees);
    }
}

Vec3 JointMoves::joints_at(double s) const {
    const Joints<double> at = joints_of(machine_.kinematics, tool_at(move_, length_, s));
    Vec3 joints(at[0], at[1], at[2]);
    go_on(joints);
    return joints;
}

JointMoves::Reach JointMoves::longest_from(double s) const {
    Reach reach;
    const ToolPose<PathSeries> tool = tool_series(move_, length_, s);
    reach.tool = coefficients(tool.xyz);
    if (!reach.tool.c.allFinite()) {
        refuse(
            fmt::format("the tool stands still within this curve, {:.6g} mm along it: joints "
                        "are drawn of curves that do not",
                        s));
    }
    reach.series = coefficients(joints_of(machine_.kinematics, tool));
    if (!reach.series.c.leftCols<1>().allFinite()) out_of_reach(s);
    check_rates(reach.series, s);
    Vec3 start = reach.series.c.col(0);
    go_on(start);
    reach.series.c.col(0) = start;
    const VectorSeries<kJointOrders> drawn = first_orders<kJointOrders>(reach.series, orders_);
    const double rest = length_ - s;
    double length = std::min(rest, longest_);
    for (int n = orders_ + 1; n <= kToolOrders; ++n) {
        const double left_out = reach.series.c.col(n).cwiseAbs().maxCoeff();
        if (left_out > 0) length = std::min(length, std::pow(tolerance_ / left_out, 1.0 / n));
    }
    while (!keeps(drawn, s, length)) {
        length /= 2;
        if (length < std::min(rest, kShortest)) {
            const double ahead = s + std::min(rest, kShortest);
            const ToolPose<PathSeries> there = tool_series(move_, length_, ahead);
            check_rates(coefficients(joints_of(machine_.kinematics, there)), ahead);
            refuse(
                fmt::format("a place {:.6g} mm along this move is singular for the machine "
                            "({}): its joints' speeds change without bounds there",
                            s, machine_.name));
        }
    }
    reach.length = length;
    return reach;
}

void JointMoves::check_rates(const VectorSeries<kToolOrders>& series, double s) const {
    for (int i = 0; i < 3; ++i) {
        const double rate = std::abs(series.c(i, 1));
        if (rate <= kMostAxisRate * stretch_) continue;
        refuse(
            fmt::format("{:.6g} mm along this move joint {} goes {:.4g} times as far as the "
                        "tool; [KINS] JOINT_RATIO allows {:.4g}",
                        s, i, rate, kMostAxisRate * stretch_));
    }
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        const double rate = std::abs(move_.aux_end[i] - move_.aux_start[i]) / length_;
        if (rate <= kMostAxisRate * stretch_) continue;
        refuse(
            fmt::format("{} goes {:.4g} times as far as the tool; [KINS] JOINT_RATIO allows "
                        "{:.4g}",
                        kAxisLetters[3 + i], rate, kMostAxisRate * stretch_));
    }
}

/// Returns whether what is drawn is near the exact joints at places up to a length, and stays
/// within its words.
bool JointMoves::keeps(const VectorSeries<kJointOrders>& drawn, double s, double length) const {
    if (drawn.most(length, 1).maxCoeff() > kMostAxisRate * stretch_) return false;
    for (int n = 2; n <= orders_; ++n) {
        const double word = drawn.c.col(n).cwiseAbs().maxCoeff() * std::pow(2 * length, n - 1);
        if (word > kMostAxisRate * stretch_) return false;
    }
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
        const Vec3 off = drawn.at(part * length) - joints_at(s + part * length);
        if (!(off.cwiseAbs().maxCoeff() <= tolerance_)) return false;
    }
    return true;
}

Move JointMoves::piece_of(const Reach& reach, double length) const {
    Move piece = move_;
    const double to = done_ + length;
    const double asked = (move_.to - move_.from) / length_;
    const bool ends = done_ + length >= length_;
    piece.kind = Move::Kind::kJoints;
    piece.start = *last_;
    piece.end = joints_at(to);
    piece.joints.stretch = stretch_;
    piece.joints.length = length * stretch_;
    piece.joints.joints = first_orders<kJointOrders>(reach.series, orders_).stretched(stretch_);
    piece.joints.tool = reach.tool.stretched(stretch_);
    piece.feed *= stretch_;
    piece.from = move_.from + asked * done_;
    if (!ends) piece.to = move_.from + asked * to;
    for (std::size_t i = 0; i < kAuxAxes; ++i) {
        const double rate = (move_.aux_end[i] - move_.aux_start[i]) / length_;
        piece.aux_start[i] = move_.aux_start[i] + rate * done_;
        if (!ends) piece.aux_end[i] = move_.aux_start[i] + rate * to;
    }
    if (!ends) {
        piece.exact_stop = false;
        piece.dwell = 0;
    }
    return piece;
}

}  // namespace curvecore::ref
