// SPDX-License-Identifier: Apache-2.0
// Words of the step generator's first half: positions into places, places into rates. Twin:
// rtl/pulse/place_scaler.sv.
#pragma once

#include <cstdint>

namespace curvecore {
namespace hls {

constexpr int kStepFraction = 16;  // fraction bits of places, in steps

/// Converts a position of fine_bits bits to 2^-16 step, rounded down; scale: their number in
/// 2^fine_bits units of the position. It is exact as the hardware adds: dropped bits are never
/// needed again.
inline std::int64_t place(std::int64_t position, std::int64_t scale, int fine_bits) {
    std::int64_t sum = 0;
    for (int bit = 0; bit < fine_bits; ++bit) {
        const std::int64_t digit = position >> bit & 1;
        sum = (sum + (bit == fine_bits - 1 ? -digit : digit) * scale) >> 1;
    }
    return sum;
}

/// Command of an axis for one sample.
struct StepRate {
    std::int64_t rate = 0;  // 2^-16 step per period
    bool fresh = false;     // the axis stands at this place: the rate is its fraction of a step
    bool moves = false;     // a rate that counts, and is not 0
    bool refused = false;  // half a step per clock or more, or a program that begins a step or more
                           // from where the axis stands: it needs a new reference
};

/// The rates of one axis. A rate has 16 + period_log2 bits: less than half a step per clock.
class PlaceScaler {
  public:
    PlaceScaler(int fine_bits, int period_log2)
        : fine_bits_(fine_bits), half_(std::int64_t(1) << (kStepFraction + period_log2 - 1)) {}

    void set_scale(std::int64_t scale) { scale_ = scale; }

    /// `begins`: the sample is a program's first, from a standstill.
    StepRate next(std::int64_t position, bool fresh, bool referenced, bool begins = false) {
        const std::int64_t here = place(position, scale_, fine_bits_);
        const std::int64_t moved = here - place_;
        place_ = here;
        StepRate result;
        result.fresh = fresh;
        if (fresh) {
            result.rate = wrapped(here, std::int64_t(1) << (kStepFraction - 1));
        } else {
            result.rate = wrapped(moved, half_);
            result.moves = referenced && result.rate != 0;
            const bool elsewhere =
                begins && moved != wrapped(moved, std::int64_t(1) << kStepFraction);
            result.refused = referenced && (result.rate != moved || elsewhere);
        }
        return result;
    }

  private:
    /// The low bits, as a signed word in [-half, half).
    static std::int64_t wrapped(std::int64_t value, std::int64_t half) {
        return ((value + half) & (2 * half - 1)) - half;
    }

    int fine_bits_;
    std::int64_t half_;
    std::int64_t scale_ = 0;
    std::int64_t place_ = 0;
};

}  // namespace hls
}  // namespace curvecore
