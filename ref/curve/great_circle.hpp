// SPDX-License-Identifier: Apache-2.0
// Closed-form motion on a great circle: the exact curve of the spherical network.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace curvecore::ref {

/// A circle about the origin, in the plane through the origin with the normal B.
///
/// | quantity  | symbol      | shape | unit | domain and remark                              |
/// |-----------|-------------|-------|------|------------------------------------------------|
/// | normal    | B           | 3     | 1    | |B| = 1; counter-clockwise about it            |
/// | start     | r0          | 3     | mm   | B . r0 = 0, R = |r0| > 0                       |
/// | partner   | f0 = B x r0 | 3     | mm   | (F, G, H) of the network, |f0| = R             |
/// | path      | s           |       | mm   | any                                            |
/// | position  | r(s)        | 3     | mm   | |r| = R                                        |
/// | tangent   | f(s) / R    | 3     | 1    | unit vector, dr/ds                             |
/// | curvature | 1 / R       |       | 1/mm |                                                |
///
///     r(s) = r0 cos(s/R) + f0 sin(s/R)        f(s) = f0 cos(s/R) - r0 sin(s/R)
///
/// Error: roundings of Real, in double |s| 2^-52 for the angle and R 2^-51 for the rest.
/// Twins: kSpherical in ref/series/figures.hpp, hls/curves/arc.hpp.
/// Source: [Chikurov] (16)-(19).
template <class Real>
class GreatCircle {
  public:
    using Vector = Eigen::Matrix<Real, 3, 1>;

    /// @throws std::invalid_argument, with the reason, unless |B| = 1, R > 0 and B . r0 = 0,
    ///         each to a relative 1e-9
    GreatCircle(const Vector& start, const Vector& normal)
        : start_(start), partner_(normal.cross(start)), radius_(start.norm()) {
        using std::abs;
        if (!(abs(normal.norm() - Real(1)) <= Real(1e-9))) {
            throw std::invalid_argument("the normal of a circle has the length 1");
        }
        if (!(radius_ > Real(0))) {
            throw std::invalid_argument("a circle starts away from its centre");
        }
        if (!(abs(normal.dot(start)) <= Real(1e-9) * radius_)) {
            throw std::invalid_argument("a circle starts in the plane of its centre");
        }
    }

    Real radius() const { return radius_; }
    Real curvature() const { return Real(1) / radius_; }
    Vector partner() const { return partner_; }

    Vector position(const Real& s) const {
        using std::cos;
        using std::sin;
        const Real angle = s / radius_;
        return start_ * cos(angle) + partner_ * sin(angle);
    }

    Vector tangent(const Real& s) const {
        using std::cos;
        using std::sin;
        const Real angle = s / radius_;
        return (partner_ * cos(angle) - start_ * sin(angle)) / radius_;
    }

  private:
    Vector start_;
    Vector partner_;
    Real radius_;
};

}  // namespace curvecore::ref
