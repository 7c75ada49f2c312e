// SPDX-License-Identifier: Apache-2.0
// An axis' places as they are given to its drive, so that what swings behind it is where the path
// is. Twin: rtl/pulse/input_shaper.sv.
//
// Of the places p(n) of samples, with a delay of k samples,
//
//   q(n) = p(n-k) + near (p(n) - p(n-k)) + far (p(n-k) - p(n-2k))
//
// is given. Which gains make a shaper or a feed-forward of it: ref/machine/shaper.hpp. Without
// motion for 2k samples q is p: nothing adds up.
#pragma once

#include <cstdint>
#include <vector>

#include "hls/place_scaler.hpp"

namespace curvecore {
namespace hls {

constexpr int kGainBits = 18;  // signed
constexpr int kGainFrac = 13;

struct ShaperWords {
    int delay = 0;  // samples; 2 delay < places
    std::int32_t near = 0;
    std::int32_t far = 0;
};

class InputShaper {
  public:
    /// @param places that are kept, a power of two
    InputShaper(int places, int period_log2)
        : places_(std::size_t(places)),
          half_(std::int64_t(1) << (kStepFraction + period_log2 - 1)) {}

    /// Sets the words, at rest.
    void set(const ShaperWords& words) { words_ = words; }

    /// Takes the rate of a sample, or of a period without one. Axes without a reference have rates
    /// that do not count.
    StepRate next(StepRate rate, bool referenced) {
        if (rate.fresh) {
            places_.assign(places_.size(), 0);
            given_ = place_ = 0;
            settled_ = true;
            return rate;
        }
        if (rate.moves) place_ += rate.rate;
        at_ = (at_ + 1) % places_.size();
        places_[at_] = place_;
        const std::int64_t middle = before(1);
        const std::int64_t last = before(2);
        const std::int64_t sum = words_.near * (place_ - middle) + words_.far * (middle - last);
        const std::int64_t given = middle + (sum >> kGainFrac);
        const std::int64_t moved = given - given_;
        given_ = given;
        settled_ = moved == 0 && place_ == middle && middle == last;
        rate.moves = referenced && moved != 0;
        rate.refused = rate.refused || (referenced && (moved < -half_ || moved >= half_));
        rate.rate = ((moved + half_) & (2 * half_ - 1)) - half_;
        return rate;
    }

    /// Returns true if the axis is at its place, and has not moved for 2k samples.
    bool settled() const { return settled_; }

  private:
    std::int64_t before(int delays) const {
        const auto back = static_cast<std::size_t>(delays) * static_cast<std::size_t>(words_.delay);
        return places_[(at_ + places_.size() - back) % places_.size()];
    }

    std::vector<std::int64_t> places_;  // of the last samples
    std::int64_t half_;
    ShaperWords words_;
    std::size_t at_ = 0;
    std::int64_t place_ = 0;
    std::int64_t given_ = 0;
    bool settled_ = true;
};

}  // namespace hls
}  // namespace curvecore
