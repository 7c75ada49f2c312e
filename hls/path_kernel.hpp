// SPDX-License-Identifier: Apache-2.0
// Words of the path generator: path increments tick by tick, from pieces of constant jerk, and
// their even share among the samples of a tick. Twin: rtl/path/path_generator.sv.
//
// Time runs at a rate r (0 .. 1, 16 fraction bits), so a hold or an override scales time inside a
// piece and leaves the path as it is. Within a piece the path is evaluated from the piece's start
// by Horner; at its end it has advanced by exactly ds: nothing accumulates.
#pragma once

#include "hls/words.hpp"

namespace curvecore {
namespace hls {

/// Number of ticks without a program after which nothing is under way: the most that are ever on
/// their way from the time scaler to the path generator.
constexpr int kIdleTicks = 16;

inline namespace CURVECORE_STORAGE {

/// Path s(tau) - s0 of a piece at `time` ticks (16 fraction bits), in quanta. Rounding: one per
/// product, one to quanta.
inline Word<kLengthBits + 1> piece_path(const ProfileWords& piece, std::int64_t time) {
    using Coef = Word<kProfileBits>;
    constexpr int kTauFrac = kProfileBits - 1;
    constexpr int kLeft = kMaxProfileExponent - kProfileFrac;
    const Coef tau = Coef(time << (kMaxTimeExponent - piece.time_exponent));
    Coef d = piece.c[2];
    d = Coef(piece.c[1] + rounded_product<Word<2 * kProfileBits>>(d, tau, kTauFrac));
    d = Coef(piece.c[0] + rounded_product<Word<2 * kProfileBits>>(d, tau, kTauFrac));
    d = rounded_product<Word<2 * kProfileBits>>(d, tau, kTauFrac);
    const Word<kLengthBits + 1> wide = Word<kLengthBits + 1>(d) * (1 << kLeft);
    return round_shift(wide, kMaxProfileExponent - piece.exponent);
}
static_assert(kMaxTimeExponent + kRateFrac == kProfileBits - 1, "time fills tau exactly");

class PathKernel {
  public:
    using Length = Word<kLengthBits + 1>;

    /// Advances time by rate / 2^16 ticks, rate in [0, 2^16]; returns the path increment in quanta.
    /// `next_piece(words)` delivers the next piece or returns false; without one, time waits at the
    /// present piece's end. No program begins in a tick that is held, one with target 0.
    template <class NextPiece>
    Length tick(std::int32_t rate, NextPiece&& next_piece, bool held = false) {
        const Length increment = advance(rate, next_piece, held);
        idle_ticks_ = active_ ? 0 : idle_ticks_ + (idle() ? 0 : 1);
        return increment;
    }

    /// Returns true while a piece is in progress: not at rest before a program or after its final
    /// piece.
    bool active() const { return active_; }
    /// Returns true if nothing is under way: the last ticks had no program.
    bool idle() const { return idle_ticks_ == kIdleTicks; }

  private:
    template <class NextPiece>
    Length advance(std::int32_t rate, NextPiece&& next_piece, bool held) {
        Length increment = 0;
        if (!active_) {
            if (held || !next_piece(piece_)) {
                return increment;
            }
            begin_piece(rate);
        } else {
            time_ += rate;
            const std::int64_t end = std::int64_t(piece_.ticks) << kRateFrac;
            if (time_ >= end) {
                increment = Length(piece_.ds - walked_);
                walked_ = piece_.ds;
                if (piece_.final) {
                    active_ = false;
                    return increment;
                }
                if (!next_piece(piece_)) {
                    time_ = end;
                    return increment;
                }
                begin_piece(time_ - end);
            }
        }
        // Words are rounded; the path goes neither back nor beyond the piece's end.
        Length path = time_ >= std::int64_t(piece_.ticks) << kRateFrac ? piece_.ds
                                                                       : piece_path(piece_, time_);
        path = path < walked_ ? walked_ : path;
        path = path > piece_.ds ? piece_.ds : path;
        increment = Length(increment + path - walked_);
        walked_ = path;
        return increment;
    }

    void begin_piece(std::int64_t time) {
        active_ = true;
        time_ = time;
        walked_ = 0;
    }

    ProfileWords piece_;
    bool active_ = false;
    int idle_ticks_ = kIdleTicks;
    std::int64_t time_ = 0;  // within the piece, ticks with 16 fraction bits
    Length walked_ = 0;      // path of the piece's ds walked
};

/// Shares a tick's increment among 2^n samples: after j of them floor(j ds / 2^n) is gone.
class SampleShare {
  public:
    using Length = Word<kLengthBits + 1>;

    explicit SampleShare(int n) : n_(n) {}

    /// Returns true if the next sample needs a new tick first.
    bool needs_tick() const { return index_ == 0; }
    void tick(const Length& ds) { ds_ = ds; }

    Length sample() {
        index_ = (index_ + 1) & ((1 << n_) - 1);
        const Length before = fraction_;
        const Length sum = Length(before + ds_);
        fraction_ = Length(sum & Length((Length(1) << n_) - 1));
        return Length(sum >> n_);
    }

  private:
    int n_;
    int index_ = 0;
    Length ds_ = 0;
    Length fraction_ = 0;
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
