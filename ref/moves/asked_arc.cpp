// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/asked_arc.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/moves/arc_geometry.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 32;  // points of a turn; the total over many turns
constexpr double kRoundingShare = 1e-14;
constexpr double kRootRounding = 8e-15;

/// Polar coordinates about the given centre.
class Polar {
  public:
    explicit Polar(const AskedArc& asked)
        : asked_(asked),
          across_(asked.normal.unitOrthogonal()),
          up_(asked.normal.cross(across_)),
          radius_(std::hypot(along(across_), along(up_))),
          from_(std::atan2(along(up_), along(across_))) {
        const Vec3 end = asked.end - asked.centre;
        turn_ = std::atan2(up_.dot(end), across_.dot(end)) - from_;
        while (turn_ * radius_ < kSamePoint) turn_ += kTurnRadians;
        turn_ += kTurnRadians * (asked.turns - 1);
        rest_ = asked.end - on_circle(1);
    }

    Vec3 at(double share) const { return on_circle(share) + share * rest_; }
    double turn() const { return turn_; }
    double rounding() const {
        return kSamePoint + asked_.loose + kRoundingShare * radius_ * (1 + turn_);
    }

  private:
    double along(const Vec3& axis) const { return axis.dot(asked_.start - asked_.centre); }

    /// Point at the height of the start.
    Vec3 on_circle(double share) const {
        const double angle = from_ + share * turn_;
        const Vec3 height = asked_.normal * asked_.normal.dot(asked_.start - asked_.centre);
        return asked_.centre + height +
               radius_ * (std::cos(angle) * across_ + std::sin(angle) * up_);
    }

    const AskedArc& asked_;
    Vec3 across_, up_;
    double radius_, from_;
    double turn_ = 0;
    Vec3 rest_;
};

}  // namespace

AskedArc AskedArc::of_radius(const Vec3& start, const Vec3& end, double radius, const Vec3& normal,
                             int turns) {
    const Vec3 flat = end - start - normal * normal.dot(end - start);
    const double ratio = flat.norm() / (2 * std::abs(radius));
    AskedArc asked{start, end, start + flat / 2, normal, turns};
    // The centre's height over the chord is a root, as uncertain as its square over it.
    const double angle = std::copysign(std::acos(std::min(1.0, ratio)), radius);
    const double round = kRootRounding * (start.norm() + end.norm() + std::abs(radius));
    const double square = std::abs(radius) * round;
    asked.loose = square / std::max(std::abs(radius * std::sin(angle)), std::sqrt(square));
    if (ratio >= 1) return asked;
    const Vec3 towards = Eigen::AngleAxisd(angle, normal) * flat.normalized();
    asked.centre = start + std::abs(radius) * towards;
    return asked;
}

double distance(const AskedArc& asked, const Move& move) {
    const Polar polar(asked);
    const double length = move.length();
    const int places =
        std::clamp(static_cast<int>(polar.turn() / kTurnRadians * kPlaces), 4, kPlaces);
    double worst = 0;
    for (int i = 0; i <= places; ++i) {
        const double share = static_cast<double>(i) / places;
        worst = std::max(worst, (place_on(move, share * length).position - polar.at(share)).norm());
    }
    return worst > polar.rounding() ? worst : 0;
}

}  // namespace curvecore::ref
