// SPDX-License-Identifier: Apache-2.0
// A tool that swings behind its drives, and the shaper's words for it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "sysc/wire/shaper_words.hpp"

namespace curvecore::tb {

constexpr double kSprungHertz = 50;
constexpr double kSprungDamping = 0.05;

/// A mass behind an axis' drive: x'' = w^2 (u - x) - 2 z w x'.
class SprungTool {
  public:
    void follow(double drive, double time) {
        speed_ += time * (kPull * (drive - place_) - kDrag * speed_);
        place_ += time * speed_;
    }
    double place() const { return place_; }

  private:
    static constexpr double kPull = 4 * M_PI * M_PI * kSprungHertz * kSprungHertz;
    static constexpr double kDrag = 4 * M_PI * kSprungDamping * kSprungHertz;
    double place_ = 0;
    double speed_ = 0;
};

/// Writes the words with which X and Y, sprung tools, are shaped.
/// @param places that the core keeps
template <class Host>
void shape(Host& host, ref::ShaperKind kind, double sample_s, int axes, int places) {
    ref::Machine machine;
    machine.shaper = kind;
    for (int axis = 0; axis < 2; ++axis) machine.modes[axis] = {kSprungHertz, kSprungDamping};
    const auto taps = ref::shaper_taps(machine, sample_s, places / 2 - 1);
    const int late = ref::tool_delay(machine, taps, sample_s);
    for (const std::uint32_t word : sysc::shaper_words(taps, axes, late)) {
        EXPECT_TRUE(host.write(CURVECORE_SHAPER, word));
    }
}

}  // namespace curvecore::tb
