// SPDX-License-Identifier: Apache-2.0
// Closed-form motion on an arc in any plane, with travel along its axis: circle and helix.
#pragma once

#include "ref/curve/great_circle.hpp"

namespace curvecore::ref {

/// | quantity  | symbol | shape | unit | domain and remark                                     |
/// |-----------|--------|-------|------|-------------------------------------------------------|
/// | start     | r(0)   | 3     | mm   | off the centre, in the plane through it               |
/// | centre    | c      | 3     | mm   |                                                       |
/// | normal    | B      | 3     | 1    | |B| = 1; counter-clockwise about it                   |
/// | angle     | a      |       | rad  | > 0, whole turns included                             |
/// | advance   | d      |       | mm   | signed travel along B over the whole arc; 0: circle   |
/// | path      | s      |       | mm   | 0 .. length() = sqrt((R a)^2 + d^2)                   |
/// | position  | r(s)   | 3     | mm   |                                                       |
/// | tangent   | dr/ds  | 3     | 1    | unit vector                                           |
/// | curvature |        |       | 1/mm | R (a / length)^2, constant                            |
///
///     r(s) = c + circle(R a s / length) + B d s / length
///
/// Error: that of GreatCircle. Source: [Chikurov] (16)-(19).
template <class Real>
class Helix {
  public:
    using Vector = Eigen::Matrix<Real, 3, 1>;

    /// @throws std::invalid_argument when the angle is not positive, and as GreatCircle
    Helix(const Vector& start, const Vector& centre, const Vector& normal, const Real& angle,
          const Real& advance = Real(0))
        : centre_(centre), normal_(normal), circle_(start - centre, normal) {
        using std::sqrt;
        if (!(angle > Real(0))) {
            throw std::invalid_argument("the angle of an arc is positive");
        }
        const Real arc = circle_.radius() * angle;
        length_ = sqrt(arc * arc + advance * advance);
        cos_pitch_ = arc / length_;
        sin_pitch_ = advance / length_;
    }

    Real radius() const { return circle_.radius(); }
    Real length() const { return length_; }
    Real curvature() const { return cos_pitch_ * cos_pitch_ / circle_.radius(); }

    Vector position(const Real& s) const {
        return centre_ + circle_.position(s * cos_pitch_) + normal_ * (s * sin_pitch_);
    }

    Vector tangent(const Real& s) const {
        return circle_.tangent(s * cos_pitch_) * cos_pitch_ + normal_ * sin_pitch_;
    }

  private:
    Vector centre_;
    Vector normal_;
    GreatCircle<Real> circle_;
    Real length_;
    Real cos_pitch_;
    Real sin_pitch_;
};

}  // namespace curvecore::ref
