// SPDX-License-Identifier: Apache-2.0
// Seeded segments at the edges of what is legal: arcs, helices and lines; whole, partial, tiny and
// empty ones; theta up to 1/2, steps and positions up to a quarter of the range.
//
// Legal: |t| = |n| = cos(pitch), t perpendicular to n, at most a quarter turn. The end word is
// random: a core must land on it, not near. Segments need not join.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb {
using namespace sysc;

class LegalSegments {
  public:
    /// Creates a generator with steps of at most 2^max_step_exponent units.
    LegalSegments(const CoreParameters& core, uint64_t seed,
                  int max_step_exponent = hls::kMaxStepExponent)
        // At most eight steps, each of at most 1/64 of the range: all points stay inside.
        : core_(core),
          random_(seed),
          max_step_exponent_(std::min(max_step_exponent, core.position_bits - 7)) {}

    RunSegment next() {
        const int coef_frac = core_.coef_bits - 2;
        const int fine_frac = core_.position_bits + core_.guard_bits - 1;
        RunSegment s;
        s.step_exponent =
            static_cast<int>(random_() % static_cast<uint64_t>(max_step_exponent_ + 1));
        const int kind = static_cast<int>(random_() % 4);
        const double pitch = kind == 0 ? uniform(-1.5, 1.5) : 0;
        const bool line = kind == 1;
        const double cos_pitch = line ? 0 : std::cos(pitch);
        const double theta = line ? 0 : uniform(0.05, 0.49) * cos_pitch;
        const Eigen::Vector3d normal = direction();
        const Eigen::Vector3d across = normal.cross(direction());
        const Eigen::Vector3d tangent =
            across.norm() > 0.1 ? across.normalized() : normal.unitOrthogonal();
        const Eigen::Vector3d axis = line ? direction() : normal.cross(tangent);
        const double rate = line ? 1 : std::sin(pitch);

        s.length = length(s.step_exponent, theta);
        s.theta = word(theta, core_.coef_bits - 1);
        for (int a = 0; a < core_.axes(); ++a) {
            s.start[a] = word(uniform(-0.25, 0.25), fine_frac);
            s.end[a] = word(uniform(-0.25, 0.25), fine_frac);
            s.advance[a] = word(a < 3 ? rate * axis[a] : uniform(-1, 1), coef_frac);
            if (a < 3) {
                s.normal[a] = word(normal[a] * cos_pitch, coef_frac);
                s.tangent[a] = word(tangent[a] * cos_pitch, coef_frac);
            }
        }
        return s;
    }

    /// A segment of full steps only.
    RunSegment whole(int step_exponent, int steps) {
        RunSegment s = next();
        s.step_exponent = step_exponent;
        s.length = int64_t{steps} << (step_exponent + hls::kPathFrac);
        return s;
    }

  private:
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// A direction, sometimes along an axis: components of exactly 0 and 1.
    Eigen::Vector3d direction() {
        switch (random_() % 6) {
            case 0:
                return Eigen::Vector3d::UnitX();
            case 1:
                return -Eigen::Vector3d::UnitZ();
            default:
                return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1))
                    .normalized();
        }
    }

    int64_t length(int k, double theta) {
        const int64_t step = int64_t{1} << (k + hls::kPathFrac);
        const double steps = theta > 0 ? std::min(8.0, M_PI / 2 / theta) : 8;
        switch (random_() % 8) {
            case 0:
                return 0;
            case 1:
                return 1 + static_cast<int64_t>(random_() % 3);
            case 2:
                return step;
            case 3:
                return 1 + static_cast<int64_t>(random_() % static_cast<uint64_t>(step));
            case 4:
                return step + 1;
            default:
                return 1 + static_cast<int64_t>(uniform(0, steps) * static_cast<double>(step));
        }
    }

    static int64_t word(double value, int frac) {
        return static_cast<int64_t>(std::llround(std::ldexp(value, frac)));
    }

    CoreParameters core_;
    std::mt19937_64 random_;
    int max_step_exponent_;
};

/// Makes segments of `length` quanta in all, each of at most `longest`; the last one is not empty.
template <class Shapes>
auto chain(Shapes& shapes, int64_t length, int64_t longest = INT64_MAX) {
    std::vector<decltype(shapes.next())> segments;
    while (length > 0) {
        segments.push_back(shapes.next());
        segments.back().length = std::min({length, segments.back().length, longest});
        length -= segments.back().length;
    }
    return segments;
}

}  // namespace curvecore::tb
