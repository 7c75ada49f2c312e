// SPDX-License-Identifier: Apache-2.0
// Segments for tests of cores: arcs, helices and lines of every size, among them empty ones and
// such as are shorter than a sample. They need not join.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hls/words.hpp"

namespace curvecore::tb {

/// Segments of `length` quanta in all; the last one is not empty.
template <class C>
std::vector<hls::SegmentWords<C>> random_segments(uint32_t seed, int64_t length) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    const auto word = [](double value, int frac) {
        return static_cast<int64_t>(std::llround(std::ldexp(value, frac)));
    };
    std::vector<hls::SegmentWords<C>> segments;
    while (length > 0) {
        hls::SegmentWords<C> segment;
        const bool line = random() % 4 == 0;
        segment.step_exponent = static_cast<int>(random() % 14);
        const double steps = std::pow(2.0, uniform(-6, 5));
        const double full = std::ldexp(1.0, segment.step_exponent + hls::kPathFrac);
        segment.length =
            random() % 8 == 0 ? 0 : std::min(length, 1 + static_cast<int64_t>(steps * full));
        length -= segment.length;
        const double pitch = uniform(-0.5, 0.5);
        const Eigen::Vector3d t =
            Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
        const Eigen::Vector3d n = t.unitOrthogonal();
        const Eigen::Vector3d advance = line ? t : Eigen::Vector3d(t.cross(n) * std::sin(pitch));
        if (!line) segment.theta = word(uniform(0.001, 0.05), C::kUnitFrac);
        for (int axis = 0; axis < C::kAxes; ++axis) {
            const double range = std::ldexp(1.0, C::kPositionBits - 2);
            segment.start[axis] = word(uniform(-range, range), C::kGuardBits);
            segment.end[axis] = word(uniform(-range, range), C::kGuardBits);
            segment.advance[axis] =
                word(axis < 3 ? advance[axis] : uniform(-1.9, 1.9), C::kCoefFrac);
            if (axis >= 3 || line) continue;
            segment.tangent[axis] = word(t[axis] * std::cos(pitch), C::kCoefFrac);
            segment.normal[axis] = word(n[axis] * std::cos(pitch), C::kCoefFrac);
        }
        segments.push_back(segment);
    }
    return segments;
}

}  // namespace curvecore::tb
