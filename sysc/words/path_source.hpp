// SPDX-License-Identifier: Apache-2.0
// The path generator's words: the increments that a plan and an override make, sample by sample.
#pragma once

#include "hls/path_kernel.hpp"
#include "hls/quantise.hpp"
#include "hls/time_scaler.hpp"
#include "sysc/words/list_view.hpp"

namespace curvecore::sysc {

class PathSource {
  public:
    /// Creates a source on a plan of any kind, which must outlive it.
    template <class Plan>
    PathSource(const Plan& plan, int samples_per_tick_log2, std::int32_t target)
        : pieces_(plan.pieces),
          scaler_(plan.hold_acceleration,
                  std::int64_t(plan.hold_acceleration) * plan.hold_slope_steps),
          share_(samples_per_tick_log2),
          target_(target) {}

    /// Moves to the next sample. Returns true if a tick began with it.
    bool next() {
        const bool tick = share_.needs_tick();
        if (tick) {
            rate_ = scaler_.tick(target_);
            const auto next_piece = [this](hls::ProfileWords& words) {
                if (piece_ == pieces_.size()) return false;
                words = hls::to_words(pieces_[piece_++]);
                return true;
            };
            tick_ds_ = path_.tick(rate_, next_piece, target_ == 0);
            share_.tick(tick_ds_);
        }
        ds_ = share_.sample();
        return tick;
    }

    std::int64_t ds() const { return ds_; }            // of the sample, quanta
    std::int64_t tick_ds() const { return tick_ds_; }  // of its tick
    std::int32_t rate() const { return rate_; }        // of time, 2^16 = 1
    /// Returns true if the plan continues after the present tick.
    bool active() const { return path_.active(); }

  private:
    ListView<ref::ProfilePiece> pieces_;
    hls::TimeScaler scaler_;
    hls::PathKernel path_;
    hls::SampleShare share_;
    std::int32_t target_;
    std::size_t piece_ = 0;
    std::int32_t rate_ = 0;
    std::int64_t tick_ds_ = 0;
    std::int64_t ds_ = 0;
};

/// Number of samples from rest to rest, in whole ticks.
template <class Plan>
std::uint64_t count_samples(const Plan& plan, int samples_per_tick_log2, std::int32_t target) {
    PathSource source(plan, 0, target);
    std::uint64_t ticks = 0;
    do {
        source.next();
        ++ticks;
    } while (source.active());
    return ticks << samples_per_tick_log2;
}

}  // namespace curvecore::sysc
