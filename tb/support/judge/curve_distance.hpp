// SPDX-License-Identifier: Apache-2.0
// Distance of a cubic from an exact curve, found by searching the whole curve: no initial guess
// that a fit could share.
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
    /// Refines the best sample by ever finer ones: derivatives would fail at a cusp.
    double refined(const ref::Vec3& point, double low, double high) const {
        double best = 1e300;
        double nearest = low;
        for (int round = 0; round < 8; ++round) {
            const double step = (high - low) / 32;
            for (int i = 0; i <= 32; ++i) {
                const double at = low + i * step;
                const double far = (curve_.at(at / kCurvePoints).position - point).norm();
                if (far < best) {
                    best = far;
                    nearest = at;
                }
            }
            low = std::max(low, nearest - step);
            high = std::min(high, nearest + step);
        }
        return best;
    }

    static constexpr int kCurvePoints = 500;
    const ref::RationalBezier& curve_;
    std::vector<ref::Vec3> points_;
};

}  // namespace curvecore::tb
