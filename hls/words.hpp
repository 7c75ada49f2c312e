// SPDX-License-Identifier: Apache-2.0
// What travels to the cores: segment and profile words. THE word formats; hardware, kernel and host
// read them here (rtl/curvecore_pkg.sv repeats the field positions, held equal by test).
//
// Segment, one field per 48-bit bus word, sign-extended, in this order:
//
//   | word  | field         | format                                                          |
//   |-------|---------------|-----------------------------------------------------------------|
//   | 0     | length        | unsigned, path quanta (2^-16 length unit); 0: consumed, counted  |
//   | 1     | theta, k      | theta [CoefBits-1:0], CoefBits-1 fraction bits; k [40:36]        |
//   | 2 ..  | start         | FineBits, GuardBits fraction bits, length units                 |
//   |       | end           | as start                                                        |
//   |       | tangent       | CoefBits, CoefBits-2 fraction bits: (B x r / R) cos(pitch)       |
//   |       | normal        | as tangent: (r / R) cos(pitch), r from the centre               |
//   |       | advance       | as tangent: linear rate per unit of path                        |
//   |       |               | five words for X, five for Y, five for Z                        |
//   | 17 .. | start, end, advance for each auxiliary axis                                     |
//
// theta is the angle of one integration step of 2^k length units: theta = 2^k cos(pitch) / R.
// A line has theta = tangent = normal = 0: it is all advance. With TurnBits theta is at most
// 2^-TurnBits: beyond it sums leave their words, and no core says so.
//
// A spline has the same words in the same places, with another meaning:
//
//   | word  | field         | format                                                          |
//   |-------|---------------|-----------------------------------------------------------------|
//   | 1     | phi, k,       | phi [CoefBits-1:0] 2^lambda / |V(0)|, CoefBits-2 fraction bits;  |
//   |       | lambda, kind  | k [40:36]; lambda [46:41]; kind [47] = 1                        |
//   | 2 ..  | a, b, c       | in the places of tangent, normal, advance, CoefBits-2 fraction  |
//   |       |               | bits: r(v) = start + 2^lambda ((a v + b) v + c) v               |
//
// Profile piece (constant jerk), five bus words:
//
//   | word | field                                                                            |
//   |------|----------------------------------------------------------------------------------|
//   | 0    | ticks [19:0] 1..2^19, m [24:20] 0..19, e [30:25] 0..46, final [31]                 |
//   | 1    | ds, unsigned, path quanta                                                        |
//   | 2..4 | c1 c2 c3: 36 bits, 34 fraction bits, in 2^e quanta                                |
#pragma once

#include "hls/configuration.hpp"
#include "hls/fixed_word.hpp"

namespace curvecore {
namespace hls {

enum class SegmentKind { kArc = 0, kSpline = 1 };  // a line is an arc without a circle

template <class C>
struct SegmentWords {
    SegmentKind kind = SegmentKind::kArc;
    Word<kLengthBits + 1> length = 0;
    Word<C::kCoefBits> theta = 0;  // of a spline: phi
    int step_exponent = 0;
    int lambda = 0;  // 0 for arcs
    Word<C::kFineBits> start[C::kAxes] = {};
    Word<C::kFineBits> end[C::kAxes] = {};
    Word<C::kCoefBits> tangent[3] = {};         // of a spline: a
    Word<C::kCoefBits> normal[3] = {};          // of a spline: b
    Word<C::kCoefBits> advance[C::kAxes] = {};  // of a spline's X Y Z: c
};

constexpr int kProfileBits = 36;                // coefficients of a profile piece
constexpr int kProfileFrac = kProfileBits - 2;  // |c| < 2
constexpr int kRateFrac = 16;                   // t and r: ticks with 16 fraction bits
constexpr int kMaxTimeExponent = 19;            // m: ticks <= 2^m
constexpr int kMaxProfileExponent = 46;         // e

struct ProfileWords {
    std::int32_t ticks = 1;
    int time_exponent = 0;
    int exponent = 0;
    bool final = false;
    Word<kLengthBits + 1> ds = 0;
    Word<kProfileBits> c[3] = {};
};

template <class C>
constexpr int segment_bus_words() {
    return 17 + 3 * C::kAuxAxes;
}
constexpr int kProfileBusWords = 5;

constexpr std::uint64_t kBusMask = (std::uint64_t(1) << kBusBits) - 1;

/// A segment as the bus and the memory file carry it; `out` has segment_bus_words<C>() words.
template <class C>
inline void pack(const SegmentWords<C>& segment, std::uint64_t* out) {
    const std::uint64_t theta_mask = (std::uint64_t(1) << C::kCoefBits) - 1;
    *out++ = static_cast<std::uint64_t>(to_int<kLengthBits + 1>(segment.length)) & kBusMask;
    *out++ = (static_cast<std::uint64_t>(to_int<C::kCoefBits>(segment.theta)) & theta_mask) |
             (static_cast<std::uint64_t>(segment.step_exponent) << 36) |
             (static_cast<std::uint64_t>(segment.lambda) << 41) |
             (static_cast<std::uint64_t>(segment.kind) << 47);
    for (int axis = 0; axis < C::kAxes; ++axis) {
        *out++ = static_cast<std::uint64_t>(to_int<C::kFineBits>(segment.start[axis])) & kBusMask;
        *out++ = static_cast<std::uint64_t>(to_int<C::kFineBits>(segment.end[axis])) & kBusMask;
        if (axis < 3) {
            *out++ =
                static_cast<std::uint64_t>(to_int<C::kCoefBits>(segment.tangent[axis])) & kBusMask;
            *out++ =
                static_cast<std::uint64_t>(to_int<C::kCoefBits>(segment.normal[axis])) & kBusMask;
        }
        *out++ = static_cast<std::uint64_t>(to_int<C::kCoefBits>(segment.advance[axis])) & kBusMask;
    }
}

/// A profile piece as the bus and the memory file carry it; `out` has kProfileBusWords words.
inline void pack(const ProfileWords& piece, std::uint64_t* out) {
    out[0] = static_cast<std::uint64_t>(piece.ticks) |
             (static_cast<std::uint64_t>(piece.time_exponent) << 20) |
             (static_cast<std::uint64_t>(piece.exponent) << 25) |
             (static_cast<std::uint64_t>(piece.final) << 31);
    out[1] = static_cast<std::uint64_t>(to_int<kLengthBits + 1>(piece.ds)) & kBusMask;
    for (int i = 0; i < 3; ++i) {
        out[2 + i] = static_cast<std::uint64_t>(to_int<kProfileBits>(piece.c[i])) & kBusMask;
    }
}

}  // namespace hls
}  // namespace curvecore
