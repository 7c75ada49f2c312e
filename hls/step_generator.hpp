// SPDX-License-Identifier: Apache-2.0
// Samples made steps of all axes, clock by clock. Twin: rtl/pulse/step_generator.sv, from the clock
// in which it has taken a sample.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hls/step_axis.hpp"

namespace curvecore {
namespace hls {

class StepGenerator {
  public:
    StepGenerator(int axes, int fine_bits, int period_log2)
        : last_((1 << period_log2) - 1),
          scalers_(axes, PlaceScaler(fine_bits, period_log2)),
          axes_(axes, StepAxis(period_log2)),
          rates_(axes),
          loads_(axes),
          fresh_(axes, false),
          stopped_(axes, true) {}

    void set_scale(int axis, std::int64_t scale) { scalers_[axis].set_scale(scale); }
    void set_times(const PulseTimes& times) { times_ = times; }

    /// Makes the next sample state where the axis stands.
    void reference(int axis) { fresh_[axis] = true; }

    /// Stops an axis from outside, behind the synchroniser.
    void stop(int axis, bool stop) { stopped_[axis] = stop; }

    /// Takes the sample of the period after the next tick, at most one a period. `begins`: a
    /// program's first.
    void sample(const std::int64_t* positions, bool begins = false) {
        moving_ = false;
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            rates_[a] = scalers_[a].next(positions[a], fresh_[a], axes_[a].referenced(), begins);
            fresh_[a] = false;
            moving_ = moving_ || rates_[a].moves;
        }
        valid_ = true;
    }

    /// Advances by one rising edge.
    void clock() {
        late_ = count_ == last_ && !valid_ && moved_ &&
                std::any_of(axes_.begin(), axes_.end(),
                            [](const StepAxis& axis) { return axis.referenced(); });
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            const bool load = count_ == int(a) + 2;
            axes_[a].clock(times_, load && !none_ ? &loads_[a] : nullptr, load && none_,
                           stopped_[a]);
        }
        if (count_ == last_) {
            none_ = !valid_;
            moved_ = valid_ && moving_;
            loads_ = rates_;
            valid_ = false;
        }
        count_ = count_ == last_ ? 0 : count_ + 1;
    }

    const StepAxis& axis(int axis) const { return axes_[axis]; }
    bool late() const { return late_; }

  private:
    PulseTimes times_;
    int last_;
    int count_ = 0;  // clocks of the period
    std::vector<PlaceScaler> scalers_;
    std::vector<StepAxis> axes_;
    std::vector<StepRate> rates_;  // rates of the taken sample
    std::vector<StepRate> loads_;  // rates of the period
    std::vector<bool> fresh_;
    std::vector<bool> stopped_;
    bool valid_ = false;
    bool none_ = true;
    bool moving_ = false;
    bool moved_ = false;
    bool late_ = false;
};

}  // namespace hls
}  // namespace curvecore
