// SPDX-License-Identifier: Apache-2.0
// The words that travel to the cores, for segments and profile. THE word formats: kernel and host
// read the fields here, and rtl/queue/words_pkg.sv is made from them.
//
// Every bus word has 48 bits: a tag [47:44] with the place of the word in its frame, and 44 bits.
// Fields are filled from bit 0; bits without a field are 0.
//
// Segment:
//
//   | tag       | word         | fields                                                         |
//   |-----------|--------------|----------------------------------------------------------------|
//   | 1         | length       | [43:0] unsigned, path quanta (2^-16 length unit); 0: consumed,  |
//   |           |              | counted                                                        |
//   | 2         | theta        | theta [35:0], CoefBits-1 fraction bits; kind [37:36];           |
//   |           |              | k [42:38]; last [43]: the program's last segment               |
//   | 3 .. 7    | start        | [43:0] FineBits, GuardBits fraction bits, length units          |
//   | for X,    | end          | as start                                                       |
//   | for Y,    | tangent      | [35:0] CoefBits, CoefBits-2 fraction bits:                      |
//   |           |              | (B x r / R) cos(pitch)                                          |
//   | for Z     | normal       | as tangent: (r / R) cos(pitch), r from the centre              |
//   |           | advance      | as tangent: linear rate per unit of path                       |
//   | 3, 4, 7   | start, end, advance for each auxiliary axis                                   |
//
//   of every axis in the advance's word: check [43:36] (hls/word_check.hpp)
//   of X in the tangent's word: sequence [43:36], one more than in the segment before, from 0
//   of X in the normal's word:  lambda [41:36]; other turn [42]: auxiliary axes may start
//   elsewhere than the segment before ended, since their words leave other whole turns out
//   of Y and Z in the tangent's and normal's words: ticks, a byte [43:36] each, low byte first:
//   the time of the profile in which the segment is drawn; a program's ticks are those of its
//   pieces, together
//
// theta is the angle of one integration step of 2^k length units: theta = 2^k cos(pitch) / R.
// A line has theta = tangent = normal = 0: it is all advance.
//
// A spline (kind 1) has the same words in the same places, with another meaning:
//
//   | tag     | word    | fields                                                                |
//   |---------|---------|-----------------------------------------------------------------------|
//   | 2       | phi     | in theta's place: 2^lambda / |V(0)| in [1, 2), CoefBits-2 fraction bits |
//   | 5, 6, 7 | a, b, c | in the places of tangent, normal, advance, CoefBits-2 fraction bits:    |
//   |         |         | r(v) = start + 2^lambda ((a v + b) v + c) v;  k <= lambda               |
//
// A segment of a table (kind 3, for cores whose engine has one) has the words that its table's bus
// names, in the same places; lambda is 0, and theta any word. Of such a core each segment has
// further words behind its others, as many as its table needs:
//
//   | 10        | further      | [35:0] CoefBits; check [43:36]                                 |
//
// Profile piece (constant jerk):
//
//   | tag      | word     | fields                                                              |
//   |----------|----------|---------------------------------------------------------------------|
//   | 8        | piece    | ticks [19:0] 1..2^m; m [24:20] 0..19; e [30:25] 0..46; final [31];   |
//   |          |          | sequence [43:36], one more than in the piece before, from 0         |
//   | 9        | ds       | [43:0] unsigned, path quanta                                        |
//   | 10 .. 12 | c1 c2 c3 | [35:0] 34 fraction bits, in 2^e quanta; check [43:36]                |
//
// A stop branch, before the piece that it belongs to (hls/stop_schedule.hpp):
//
//   | tag | word | fields                                                              |
//   |-----|------|---------------------------------------------------------------------|
//   | 13  | stop | wait [19:0] 1 ..: ticks that a stop waits for the next one, at most; |
//   |     |      | again [20]: the steps are those of the branch before, and do not come |
//   | 14  | step | ticks [10:0] 1 ..; change [42:11] of the slope of time's rate, each |
//   |     |      | tick, 2^-32 per tick; last [43]                                     |
//
// A change of outputs, before the piece in which the path comes to its place, for boards that have
// outputs (hls/path_outputs.hpp):
//
//   | tag | word   | fields                                                              |
//   |-----|--------|---------------------------------------------------------------------|
//   | 15  | output | distance [25:0] from the place of the change before, in whole length |
//   |     |        | units; value [37:26]; kind [39:38] 0 bits, 1 level, 2 follow;        |
//   |     |        | number [43:40], one more than in the change before, from 0           |
//
// A program ends with a last segment and a final piece, both at the same path. No word of zeros and
// no word of ones is legal.
#pragma once

#include "hls/configuration.hpp"
#include "hls/fixed_word.hpp"
#include "hls/time_scaler.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A line is an arc without a circle; a table is any other curve (ref/curves/curve_table.hpp).
enum class SegmentKind { kArc = 0, kSpline = 1, kTable = 3 };

constexpr std::uint64_t kFurtherTag = 10;  // of no other word in the stream of segments

template <class C>
struct SegmentWords {
    SegmentKind kind = SegmentKind::kArc;
    Word<kLengthBits + 1> length = 0;
    typename C::Coef theta = 0;  // phi of a spline
    int step_exponent = 0;
    int lambda = 0;           // 0 for arcs
    std::uint32_t ticks = 0;  // ticks of the profile while it is drawn
    bool last = false;        // last segment of its program
    bool other_turn = false;  // auxiliary axes' words leave other turns out than before
    typename C::Fine start[C::kMostAxes] = {};
    typename C::Fine end[C::kMostAxes] = {};
    typename C::Coef tangent[3] = {};             // a of a spline
    typename C::Coef normal[3] = {};              // b of a spline
    typename C::Coef advance[C::kMostAxes] = {};  // c of a spline in X Y Z
    typename C::Further further = {};
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

/// A field: bits [low + bits - 1 : low] of a bus word.
struct Field {
    int low;
    int bits;
};

constexpr int kWordsVersion = 6;  // version of these formats; in every file of words

enum class Tag {
    kLength = 1,
    kTheta,
    kStart,
    kEnd,
    kTangent,
    kNormal,
    kAdvance,
    kPiece,
    kDs,
    kC1,
    kC2,
    kC3,
    kStop,
    kStep,
    kOutput
};
constexpr Field kTagField{44, 4};
constexpr Field kLengthField{0, ref::kBusLengthBits};  // also ds
constexpr Field kPointField{0, 44};
constexpr Field kCoefField{0, 36};
constexpr Field kKindField{36, 2};
constexpr Field kStepExponentField{38, 5};
constexpr Field kLastField{43, 1};
constexpr Field kSequenceField{36, 8};  // also a piece's
constexpr Field kCheckField{36, 8};
constexpr Field kLambdaField{36, 6};
constexpr Field kOtherTurnField{42, 1};
constexpr Field kTicksByteField{36, 8};
constexpr Field kPieceTicksField{0, 20};
constexpr Field kTimeExponentField{20, 5};
constexpr Field kExponentField{25, 6};
constexpr Field kFinalField{31, 1};

constexpr Field kStopWaitField{0, ref::kStopWaitBits};
constexpr Field kStopAgainField{20, 1};
constexpr Field kStepTicksField{0, ref::kStepTicksBits};
constexpr Field kStepChangeField{11, 32};
constexpr Field kStepLastField{43, 1};

constexpr Field kOutputDistanceField{0, 26};
constexpr Field kOutputValueField{26, 12};
constexpr Field kOutputKindField{38, 2};
constexpr Field kOutputNumberField{40, 4};

constexpr std::uint64_t mask(Field field) { return (std::uint64_t(1) << field.bits) - 1; }
constexpr std::uint64_t put(Field field, std::int64_t value) {
    return (static_cast<std::uint64_t>(value) & mask(field)) << field.low;
}
constexpr std::uint64_t get(Field field, std::uint64_t word) {
    return (word >> field.low) & mask(field);
}

namespace detail {
inline std::uint64_t bus_word(Tag tag, Field field, std::int64_t value) {
    return put(kTagField, static_cast<int>(tag)) | put(field, value);
}
/// Returns the low `bits` of a bus word as a signed value.
inline std::int64_t signed_bits(std::uint64_t word, int bits) {
    return static_cast<std::int64_t>(word << (64 - bits)) >> (64 - bits);
}

/// Pack and unpack further words, of a format with and without.
template <class C>
inline void pack_further(const NoFurther&, std::uint64_t*, const C&) {}
template <class C, class Further>
inline void pack_further(const Further& further, std::uint64_t* out, const C& c) {
    for (int n = 0; n < c.kFurtherWords; ++n) {
        *out++ = put(kTagField, static_cast<std::int64_t>(kFurtherTag)) |
                 put(kCoefField, to_int(further[n]));
    }
}
template <class C, class Coef>
inline void unpack_further(NoFurther&, const Coef&, const C&) {}
template <class C, class Coef, class Further>
inline void unpack_further(Further& further, const Coef& coef, const C& c) {
    for (int n = 0; n < c.kFurtherWords; ++n) further[n] = coef();
}
}  // namespace detail

/// Packs a segment as the bus and the memory file carry it, without its checks
/// (hls/word_check.hpp): 17 + 3 AuxAxes words to `out`, and the further ones.
template <class C>
inline void pack(const SegmentWords<C>& segment, unsigned sequence, std::uint64_t* out,
                 const C& c = C()) {
    using detail::bus_word;
    *out++ = bus_word(Tag::kLength, kLengthField, to_int(segment.length));
    *out++ = bus_word(Tag::kTheta, kCoefField, to_int(segment.theta)) |
             put(kKindField, static_cast<int>(segment.kind)) |
             put(kStepExponentField, segment.step_exponent) | put(kLastField, segment.last);
    for (int axis = 0; axis < c.kAxes; ++axis) {
        *out++ = bus_word(Tag::kStart, kPointField, to_int(segment.start[axis]));
        *out++ = bus_word(Tag::kEnd, kPointField, to_int(segment.end[axis]));
        if (axis < 3) {
            const std::int64_t ticks = axis == 0 ? 0 : segment.ticks >> (16 * (axis - 1));
            *out++ = bus_word(Tag::kTangent, kCoefField, to_int(segment.tangent[axis])) |
                     (axis == 0 ? put(kSequenceField, sequence) : put(kTicksByteField, ticks));
            *out++ = bus_word(Tag::kNormal, kCoefField, to_int(segment.normal[axis])) |
                     (axis == 0 ? put(kLambdaField, segment.lambda) |
                                      put(kOtherTurnField, segment.other_turn)
                                : put(kTicksByteField, ticks >> 8));
        }
        *out++ = bus_word(Tag::kAdvance, kCoefField, to_int(segment.advance[axis]));
    }
    detail::pack_further(segment.further, out, c);
}

/// Unpacks a segment without sequence and ticks, the inverse; next() gives a bus word.
template <class C, class Next>
inline SegmentWords<C> unpack_segment(Next&& next, const C& c = C()) {
    const auto coef = [&c](std::uint64_t word) {
        return typename C::Coef(detail::signed_bits(word, c.kCoefBits));
    };
    const auto fine = [&c](std::uint64_t word) {
        return typename C::Fine(detail::signed_bits(word, c.kFineBits));
    };
    SegmentWords<C> segment;
    segment.length = static_cast<std::int64_t>(get(kLengthField, next()));
    const std::uint64_t head = next();
    segment.theta = coef(head);
    segment.kind = static_cast<SegmentKind>(get(kKindField, head));
    segment.step_exponent = static_cast<int>(get(kStepExponentField, head));
    segment.last = get(kLastField, head) != 0;
    for (int axis = 0; axis < c.kAxes; ++axis) {
        segment.start[axis] = fine(next());
        segment.end[axis] = fine(next());
        if (axis < 3) {
            segment.tangent[axis] = coef(next());
            const std::uint64_t normal = next();
            segment.normal[axis] = coef(normal);
            if (axis == 0) segment.lambda = static_cast<int>(get(kLambdaField, normal));
        }
        segment.advance[axis] = coef(next());
    }
    detail::unpack_further(
        segment.further, [&] { return coef(next()); }, c);
    return segment;
}

/// Packs a profile piece as the bus and the memory file carry it, without its checks; `out` has
/// kProfileBusWords words.
inline void pack(const ProfileWords& piece, unsigned sequence, std::uint64_t* out) {
    out[0] = put(kTagField, static_cast<int>(Tag::kPiece)) | put(kPieceTicksField, piece.ticks) |
             put(kTimeExponentField, piece.time_exponent) | put(kExponentField, piece.exponent) |
             put(kFinalField, piece.final) | put(kSequenceField, sequence);
    out[1] = detail::bus_word(Tag::kDs, kLengthField, to_int(piece.ds));
    for (int i = 0; i < 3; ++i) {
        const Tag tag = static_cast<Tag>(static_cast<int>(Tag::kC1) + i);
        out[2 + i] = detail::bus_word(tag, kCoefField, to_int(piece.c[i]));
    }
}

inline std::uint64_t pack_stop(std::int32_t wait, bool again = false) {
    return detail::bus_word(Tag::kStop, kStopWaitField, wait) | put(kStopAgainField, again);
}
inline std::uint64_t pack(const StopStep& step) {
    return put(kTagField, static_cast<int>(Tag::kStep)) | put(kStepTicksField, step.ticks) |
           put(kStepChangeField, step.change) | put(kStepLastField, step.last);
}
inline StopStep unpack_step(std::uint64_t word) {
    StopStep step;
    step.ticks = static_cast<std::int32_t>(get(kStepTicksField, word));
    step.change =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(get(kStepChangeField, word)));
    step.last = get(kStepLastField, word) != 0;
    return step;
}

/// Unpacks a piece without the sequence, the inverse.
template <class Next>
inline ProfileWords unpack_piece(Next&& next) {
    ProfileWords piece;
    const std::uint64_t head = next();
    piece.ticks = static_cast<std::int32_t>(get(kPieceTicksField, head));
    piece.time_exponent = static_cast<int>(get(kTimeExponentField, head));
    piece.exponent = static_cast<int>(get(kExponentField, head));
    piece.final = get(kFinalField, head) != 0;
    piece.ds = static_cast<std::int64_t>(get(kLengthField, next()));
    for (auto& c : piece.c) {
        c = detail::signed_bits(next(), kProfileBits);
    }
    return piece;
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
