// SPDX-License-Identifier: Apache-2.0
// A surface in chords, as a CAM program cuts it.
#pragma once

#include <cmath>
#include <cstddef>

#include "ref/feed/plan_stream.hpp"  // for Move: older trees have it elsewhere (plan_cost.cpp)

namespace curvecore::tb {

/// Rows to and fro over y, z = f(x, y).
class Surface {
  public:
    static constexpr double kRow = 100;    // mm
    static constexpr double kApart = 0.5;  // mm: distance of rows
    static constexpr double kFeed = 100;   // mm/s

    Surface(std::size_t chords, double chord)
        : chords_(chords), chord_(chord), row_(static_cast<std::size_t>(kRow / chord)) {}

    bool next(ref::Move& move) {
        if (made_ == chords_) return false;
        move = ref::Move();
        move.feed = kFeed;
        move.tolerance = 0.01;
        move.start = at(made_);
        move.end = at(++made_);
        return true;
    }

  private:
    ref::Vec3 at(std::size_t place) const {
        const std::size_t row = place / (row_ + 1);
        const std::size_t chord = place % (row_ + 1);
        const double x = chord_ * static_cast<double>(row % 2 == 0 ? chord : row_ - chord);
        const double y = kApart * static_cast<double>(row);
        return {x, y, 3 * std::sin(x / 7) * std::cos(y / 9) + 1.5 * std::sin(x / 2.5 + y / 4)};
    }

    std::size_t chords_;
    double chord_;  // mm
    std::size_t row_;
    std::size_t made_ = 0;
};

}  // namespace curvecore::tb
