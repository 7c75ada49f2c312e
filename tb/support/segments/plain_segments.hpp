// SPDX-License-Identifier: Apache-2.0
// Random segments for the kernels alone, without a planner: C++14, any storage, the same on every
// machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "hls/words.hpp"

namespace curvecore {
namespace tb {
inline namespace CURVECORE_STORAGE {

using namespace curvecore::hls;

/// A plain generator: the same numbers on every machine.
class Random {
  public:
    double uniform(double low, double high) {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return low + (high - low) * std::ldexp(static_cast<double>(state_ >> 11), -53);
    }

  private:
    std::uint64_t state_ = 1;
};

template <class C>
SegmentWords<C> random_segment(Random& random) {
    SegmentWords<C> segment;
    const double radius = std::exp(random.uniform(std::log(1e3), std::log(1e6)));
    int k = 0;
    while (std::ldexp(1.0, k + 1) < 0.3 * radius) ++k;
    const double pitch = random.uniform(0, 1);
    const double angle = random.uniform(0, 6.28);
    const double one = std::ldexp(1.0, C::kCoefFrac);
    const double wave[3] = {std::cos(angle) * std::cos(pitch), std::sin(angle) * std::cos(pitch),
                            0};
    segment.length = std::int64_t(random.uniform(1, 1.5 * radius * 65536));
    segment.step_exponent = k;
    segment.theta =
        std::int64_t(std::ldexp(std::cos(pitch) / radius, k) * std::ldexp(1.0, C::kUnitFrac));
    for (int axis = 0; axis < C::kAxes; ++axis) {
        segment.start[axis] = std::int64_t(random.uniform(-1e6, 1e6));
        segment.end[axis] = std::int64_t(random.uniform(-1e6, 1e6));
        segment.advance[axis] = std::int64_t(random.uniform(-0.9, 0.9) * one);
    }
    for (int axis = 0; axis < 3; ++axis) {
        segment.normal[axis] = std::int64_t(wave[axis] * one);
        segment.tangent[axis] = std::int64_t((axis == 0 ? -wave[1] : wave[(axis + 2) % 3]) * one);
    }
    return segment;
}

/// A spline whose V runs over a parabola through three points of a circle, at 0.6 .. 0.9 of
/// 2^lambda: it turns by up to 1.2 rad, out of the plane too. Steps are short enough for every
/// word's range.
template <class C>
SegmentWords<C> random_spline(Random& random) {
    SegmentWords<C> segment = random_segment<C>(random);
    segment.kind = SegmentKind::kSpline;
    segment.lambda = int(random.uniform(4, 24));
    segment.step_exponent = segment.lambda - 4 + int(random.uniform(0, 3.99)) % 3;
    if (segment.step_exponent > segment.lambda - 3) segment.step_exponent = segment.lambda - 3;
    const double part = random.uniform(0.01, 0.9);
    segment.length = std::int64_t(std::ldexp(0.6 * part, segment.lambda + kPathFrac)) + 1;
    const double turn = random.uniform(-1.2, 1.2);
    const double from = random.uniform(0, 6.28);
    const double speed = random.uniform(0.65, 0.85);
    const double lift = random.uniform(-0.05, 0.05);
    double norm = 0;
    const double one = std::ldexp(1.0, C::kCoefFrac);
    for (int axis = 0; axis < 3; ++axis) {
        double point[3];
        for (int i = 0; i < 3; ++i) {
            const double angle = from + turn * i / 2;
            point[i] = axis == 0 ? std::cos(angle) : axis == 1 ? std::sin(angle) : lift * i;
        }
        const double c = speed * point[0];
        const double b = speed * (4 * point[1] - 3 * point[0] - point[2]) / 2;
        const double a = speed * (2 * point[0] - 4 * point[1] + 2 * point[2]) / 3;
        norm += c * c;
        segment.tangent[axis] = std::int64_t(a * one);
        segment.normal[axis] = std::int64_t(b * one);
        segment.advance[axis] = std::int64_t(c * one);
    }
    segment.theta = std::int64_t(one / std::sqrt(norm));
    return segment;
}

}  // namespace CURVECORE_STORAGE
}  // namespace tb
}  // namespace curvecore
