// SPDX-License-Identifier: Apache-2.0
// How far a cubic strays from an exact curve, found by searching the whole curve: no starting guess
// that a fit could have shared.
#pragma once

#include <algorithm>
#include <vector>

#include "ref/curve/fit/rational_bezier.hpp"

namespace curvecore::tb {

class CurveDistance {
  public:
    explicit CurveDistance(const ref::RationalBezier& curve) : curve_(curve) {
        for (int i = 0; i <= kCurvePoints; ++i) {
            points_.push_back(curve.at(static_cast<double>(i) / kCurvePoints).position);
        }
    }

    /// Worst distance of 50 points of the cubic.
    double of(const ref::Cubic& cubic) const {
        double worst = 0;
        for (int i = 0; i <= 50; ++i) worst = std::max(worst, of(cubic.position(i / 50.0)));
        return worst;
    }

    double of(const ref::Vec3& point) const {
        std::vector<double> far;
        for (const ref::Vec3& there : points_) far.push_back((there - point).norm());
        double best = far[0];
        for (int i = 0; i <= kCurvePoints; ++i) {
            const int before = std::max(i - 1, 0);
            const int behind = std::min(i + 1, kCurvePoints);
            if (far[i] <= far[before] && far[i] <= far[behind]) {
                best = std::min(best, refined(point, before, behind));
            }
        }
        return best;
    }

  private:
    double refined(const ref::Vec3& point, double low, double high) const {
        for (int i = 0; i < 50; ++i) {  // where the distance stops falling
            const double middle = (low + high) / 2;
            const ref::RationalBezier::Point here = curve_.at(middle / kCurvePoints);
            ((here.position - point).dot(here.derivative) < 0 ? low : high) = middle;
        }
        return (curve_.at(low / kCurvePoints).position - point).norm();
    }

    static constexpr int kCurvePoints = 500;
    const ref::RationalBezier& curve_;
    std::vector<ref::Vec3> points_;
};

}  // namespace curvecore::tb
