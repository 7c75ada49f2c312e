// SPDX-License-Identifier: Apache-2.0
// A circle or a cubic in mm, exact, for any interpolator to follow.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ref/curve/arc_length.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::tb {

/// | quantity | unit | remark                                                       |
/// |----------|------|--------------------------------------------------------------|
/// | s        | mm   | path length, beyond the ends taken as the end                |
/// | off      | mm   | distance of a point from the curve, the whole of it searched |
class DrawnCurve {
  public:
    /// Full circle about the origin, from (radius, 0, 0).
    explicit DrawnCurve(double radius) : radius_(radius), length_(2 * M_PI * radius) {}
    explicit DrawnCurve(const ref::Cubic& cubic) : cubic_(cubic), path_(cubic) {
        length_ = path_->length();
        for (int i = 0; i <= kPlaces; ++i) {
            places_.push_back(cubic_.position(path_->parameter(length_ * i / kPlaces)));
        }
    }

    bool circle() const { return !path_; }
    double radius() const { return radius_; }
    const ref::Cubic& cubic() const { return cubic_; }
    double length() const { return length_; }

    ref::Vec3 position(double s) const {
        if (path_) return cubic_.position(path_->parameter(s));
        const double angle = std::min(s, length_) / radius_;
        return radius_ * ref::Vec3(std::cos(angle), std::sin(angle), 0);
    }
    ref::Vec3 tangent(double s) const {
        if (path_) return ref::tangent(cubic_, path_->parameter(s));
        const double angle = std::min(s, length_) / radius_;
        return {-std::sin(angle), std::cos(angle), 0};
    }

    double off(const ref::Vec3& point) const {
        if (!path_) return std::hypot(point.head<2>().norm() - radius_, point[2]);
        const auto nearest = std::min_element(
            places_.begin(), places_.end(), [&](const ref::Vec3& a, const ref::Vec3& b) {
                return (a - point).squaredNorm() < (b - point).squaredNorm();
            });
        const double s = length_ * static_cast<double>(nearest - places_.begin()) / kPlaces;
        double low = s - length_ / kPlaces;
        double high = s + length_ / kPlaces;
        double u = path_->parameter(s);
        const double from = path_->parameter(low);
        const double to = path_->parameter(high);
        for (int i = 0; i < 8; ++i) {
            const ref::Vec3 velocity = cubic_.velocity(u);
            u += velocity.dot(point - cubic_.position(u)) / velocity.squaredNorm();
            u = std::clamp(u, from, to);
        }
        return (point - cubic_.position(u)).norm();
    }

    /// Returns the curve as a program's move.
    ref::Move move(double feed) const {
        ref::Move move;
        move.line = 1;
        move.feed = feed;
        move.start = position(0);
        move.end = position(length_);
        if (path_) {
            move.kind = ref::Move::Kind::kCubic;
            move.cubic = cubic_;
        } else {
            move.kind = ref::Move::Kind::kArc;
            move.end = move.start;
            move.angle = 2 * M_PI;
        }
        return move;
    }

  private:
    static constexpr int kPlaces = 2000;

    double radius_ = 0;
    ref::Cubic cubic_;
    std::optional<ref::ArcLength> path_;
    double length_ = 0;
    std::vector<ref::Vec3> places_;
};

}  // namespace curvecore::tb
