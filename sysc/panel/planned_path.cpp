// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/planned_path.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/piece_walk.hpp"
#include "ref/machine/path_quantum.hpp"
#include "ref/plan/segment_curve.hpp"

namespace curvecore::sysc {
namespace {

/// Points on a curved segment.
constexpr double kPointEvery = 0.5;  // mm
constexpr double kLeastPoints = 4;
constexpr double kMostOnCurve = 64;

}  // namespace

void PlannedPath::add(const ref::Plan& part) {
    const std::lock_guard lock(mutex_);
    tick_s_ = part.tick_s;
    quantum_mm_ = ref::path_quantum_mm(machine_, part.unit_mm);
    for (const ref::Segment& segment : part.segments) add(segment, part.unit_mm);
    for (const ref::ProfilePiece& piece : part.pieces) {
        pieces_.push_back({path_, time_s_, piece});
        if (piece.ds == 0) rests_.push_back(path_);
        path_ += piece.ds;
        time_s_ += piece.ticks * part.tick_s;
    }
}

void PlannedPath::add(const ref::Segment& segment, double unit_mm) {
    const std::uint64_t begin = begin_ + segment.s_start;
    stretches_.push_back({begin + segment.length, segment.line});
    const double length = static_cast<double>(segment.length) * ref::kQuantum;
    const bool straight = segment.kind() == ref::CurveKind::kArc && segment.arc().radius == 0;
    const double length_mm = static_cast<double>(segment.length) * quantum_mm_;
    const double wanted = std::ceil(length_mm / kPointEvery);
    const double parts = straight ? 1 : std::clamp(wanted, kLeastPoints, kMostOnCurve);
    const double begin_mm = static_cast<double>(begin) * quantum_mm_;
    const auto show = [&](double part, bool kept) {
        const auto point = [&] {
            const double s = length * part;
            const ref::AxisPoint at = ref::exact_point(segment, ref::exact_position(segment, s), s);
            const ref::Vec3 tool =
                ref::tool_of(machine_.kinematics, ref::Vec3(at[0], at[1], at[2]) * unit_mm,
                             ref::Vec3(at[3], at[4], at[5]) * unit_mm);
            return ShownPoint{tool, begin_mm + part * length_mm, segment.line};
        };
        points_.add(point, kept);
    };
    if (points_.empty()) show(0, true);
    for (double n = 1; n <= parts; ++n) show(n / parts, segment.last && n == parts);
}

void PlannedPath::forget(std::uint64_t path) {
    while (stretches_.size() > 1 && stretches_.front().end <= path) stretches_.pop_front();
    while (!rests_.empty() && rests_.front() < path) rests_.pop_front();
    while (pieces_.size() > 1 && pieces_[1].begin <= path) pieces_.pop_front();
}

void PlannedPath::pass(std::uint64_t path) {
    const std::lock_guard lock(mutex_);
    forget(path);
}

PathPlace PlannedPath::at(std::uint64_t path) {
    const std::lock_guard lock(mutex_);
    forget(path);
    PathPlace place;
    if (!stretches_.empty()) place.line = stretches_.front().line;
    if (pieces_.empty()) return place;
    const Piece& now = pieces_.front();
    const double gone =
        std::min(static_cast<double>(path - now.begin), static_cast<double>(now.piece.ds));
    const bool rests = now.piece.ds == 0;  // counts as passed
    const double ticks = rests ? now.piece.ticks : ref::ticks_at(now.piece, gone);
    place.time_s = now.time_s + ticks * tick_s_;
    place.feed_mm_s = ref::piece_state(now.piece, ticks).v * quantum_mm_ / tick_s_;
    return place;
}

bool PlannedPath::rests_at(std::uint64_t path) {
    const std::lock_guard lock(mutex_);
    forget(path);
    return !rests_.empty() && rests_.front() == path;
}

double PlannedPath::time_s() const {
    const std::lock_guard lock(mutex_);
    return time_s_;
}

double PlannedPath::length_mm() const {
    const std::lock_guard lock(mutex_);
    return static_cast<double>(path_) * quantum_mm_;
}

std::string PlannedPath::json(std::size_t from) const {
    const std::lock_guard lock(mutex_);
    return points_.json(from);
}

}  // namespace curvecore::sysc
