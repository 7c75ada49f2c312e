// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/pieces/profile_course.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/pieces/piece_loads.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr double kCellTime = 0.4e-3;  // s, or longer where
constexpr double kCellTurn =
    0.03;                          // rad is what a curve turns at most: its derivatives go linearly
constexpr double kNoLimit = 1e15;  // of acceleration and jerk; its square is a number
constexpr double kSameShare = 1e-6;  // share of a speed, of a limit

bool same(const PlaceLimits& a, const PlaceLimits& b) {
    const auto equal = [](const PlaceLimit& x, const PlaceLimit& y) {
        const auto near = [](double p, double q) {
            return std::abs(p - q) <= kSameShare * std::abs(p);
        };
        return near(x.d11, y.d11) && near(x.d12, y.d12) && near(x.d13, y.d13) &&
               near(x.d22, y.d22) && near(x.d23, y.d23) && near(x.d33, y.d33) &&
               near(x.acceleration, y.acceleration) && near(x.jerk, y.jerk);
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

}  // namespace

ProfileCourse::ProfileCourse(const Program& program, const Machine& machine,
                             const Geometry& geometry, const Plan& plan, double share)
    : machine_(machine),
      plan_(plan),
      share_(share),
      quantum_(plan.unit_mm * kQuantum),
      places_(program, geometry, plan.unit_mm),
      piece_(plan.pieces.data()) {}

void ProfileCourse::add(const PieceStretch& stretch) {
    for (; piece_ != stretch.piece; ++piece_) piece_start_ += piece_->ticks;
    const double seconds = (stretch.to - stretch.from) * plan_.tick_s;
    const PathShape& shape = stretch.move->shape;
    const double bend = std::max(shape.curvature, std::sqrt(shape.swerve));
    const double turn = (place_of(stretch, stretch.to) - stretch.s) * quantum_ * bend;
    const int parts =
        std::max(1, static_cast<int>(std::ceil(std::min(seconds / kCellTime, turn / kCellTurn))));
    PlaceLimits begin = limits(stretch, 0);
    for (int i = 0; i < parts; ++i) {
        const auto at = [&](int part) {
            return piece_start_ + stretch.from + (stretch.to - stretch.from) * part / parts;
        };
        PlaceLimits end = limits(stretch, (i + 1.) / parts);
        const PieceMotion start = ref::motion(stretch, static_cast<double>(i) / parts, plan_);
        cells_.push_back({at(i), at(i + 1), start, std::move(begin), end});
        begin = std::move(end);
    }
}

void ProfileCourse::forget_before(double tick) {
    while (!cells_.empty() && cells_.front().to <= tick) cells_.pop_front();
}

PlaceLimits ProfileCourse::limits(const PieceStretch& stretch, double part) {
    part = std::clamp(part, kWithinStretch, 1 - kWithinStretch);
    const double t = stretch.from + (stretch.to - stretch.from) * part;
    const double s = place_of(stretch, t) * quantum_;
    const PlannedMove& move = *stretch.move;
    const PieceMotion m = ref::motion(stretch, part, plan_);
    PlaceLimits all = place_limits(places_.at(stretch.move_index, s), move.shape, machine_);
    const bool tip = near_standstill(move, s, quantum_);
    for (PlaceLimit& limit : all) {
        if (tip) {
            limit = PlaceLimit();
            limit.acceleration = limit.jerk = kNoLimit;
            continue;
        }
        limit.acceleration =
            std::max(share_ * limit.acceleration, acceleration_of(limit, m.v, m.a));
        limit.jerk = std::max(share_ * limit.jerk, jerk_of(limit, m.v, m.a, m.j));
    }
    return all;
}

bool ProfileCourse::even(double from, double to) const {
    const CourseCell* first = nullptr;
    double end = from;  // end of what was checked
    double speed = 0;
    for (const CourseCell& cell : cells_) {
        if (cell.to <= from) continue;
        if (cell.from >= to) break;
        if (first == nullptr) {
            first = &cell;
            speed = motion(cell, cell.from).v;
        }
        if (cell.from > end || !same(first->begin, cell.begin) || !same(first->begin, cell.end)) {
            return false;
        }
        for (const double tick : {cell.from, (cell.from + cell.to) / 2, cell.to}) {
            if (std::abs(motion(cell, tick).v - speed) > kSameShare * speed) return false;
        }
        end = cell.to;
    }
    return end >= to;
}

}  // namespace curvecore::ref
