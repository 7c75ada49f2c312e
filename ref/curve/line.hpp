// SPDX-License-Identifier: Apache-2.0
// Closed-form motion on a straight line.
#pragma once

#include <Eigen/Core>
#include <stdexcept>

namespace curvecore::ref {

/// | quantity  | symbol | shape | unit | domain and remark          |
/// |-----------|--------|-------|------|----------------------------|
/// | ends      |        | 3, 3  | mm   | different                  |
/// | path      | s      |       | mm   | 0 .. length()              |
/// | position  | r(s)   | 3     | mm   | r(0) = start               |
/// | tangent   |        | 3     | 1    | unit vector, dr/ds         |
/// | curvature |        |       | 1/mm | 0                          |
///
/// Error: roundings of Real only.
template <class Real>
class Line {
  public:
    using Vector = Eigen::Matrix<Real, 3, 1>;

    /// @throws std::invalid_argument when the ends are the same
    Line(const Vector& start, const Vector& end) : start_(start), length_((end - start).norm()) {
        if (!(length_ > Real(0))) {
            throw std::invalid_argument("a line needs two different ends");
        }
        tangent_ = (end - start) / length_;
    }

    Real length() const { return length_; }
    Real curvature() const { return Real(0); }
    Vector position(const Real& s) const { return start_ + tangent_ * s; }
    Vector tangent(const Real& /*s*/) const { return tangent_; }

  private:
    Vector start_;
    Real length_;
    Vector tangent_;
};

}  // namespace curvecore::ref
