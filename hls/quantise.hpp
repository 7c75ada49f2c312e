// SPDX-License-Identifier: Apache-2.0
// Plan to words: the place where real numbers become words, except pieces of a profile and steps of
// stops, which the planner rounds (ref/feed/pieces/profile_words.hpp has the reason).
#pragma once

#include <cmath>
#include <stdexcept>

#include "hls/words.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// Returns value * 2^frac to nearest, as a word of `bits`.
/// @throws std::range_error if the word cannot hold it: the planner guarantees that it can
inline std::int64_t quantise(double value, int frac, int bits) {
    const double scaled = std::floor(std::ldexp(value, frac) + 0.5);
    const double limit = std::ldexp(1.0, bits - 1);
    if (!(scaled >= -limit && scaled < limit)) {
        throw std::range_error("a planned value does not fit its word");
    }
    return static_cast<std::int64_t>(scaled);
}

/// Returns an unsigned word of `bits`.
/// @throws std::range_error if the word cannot hold it
inline std::int64_t whole(std::uint64_t value, int bits) {
    if (value >> bits != 0) throw std::range_error("a planned length does not fit its word");
    return static_cast<std::int64_t>(value);
}

namespace detail {
inline void set_further(NoFurther&, int, std::int64_t) {
    throw std::range_error("a table's words, and the format has none for them");
}
template <class Further>
inline void set_further(Further& further, int n, std::int64_t word) {
    further[static_cast<std::size_t>(n)] = word;
}
}  // namespace detail

/// Set the words of a curve: head and coefficients of X Y Z.
template <class C>
inline void curve_words(const ref::ArcPiece& arc, int step_exponent, const C& c,
                        SegmentWords<C>& words) {
    words.kind = SegmentKind::kArc;
    words.theta = quantise(std::ldexp(arc.twist(), step_exponent), c.kUnitFrac, c.kCoefBits);
    for (int axis = 0; axis < 3; ++axis) {
        words.tangent[axis] = quantise(arc.tangent[axis] * arc.cos_pitch, c.kCoefFrac, c.kCoefBits);
        words.normal[axis] = quantise(arc.normal[axis] * arc.cos_pitch, c.kCoefFrac, c.kCoefBits);
        words.advance[axis] = quantise(arc.advance[axis], c.kCoefFrac, c.kCoefBits);
    }
}

template <class C>
inline void curve_words(const ref::SplinePiece& spline, int /*step_exponent*/, const C& c,
                        SegmentWords<C>& words) {
    words.kind = SegmentKind::kSpline;
    words.lambda = spline.lambda;
    words.theta = quantise(1 / spline.c.norm(), c.kCoefFrac, c.kCoefBits);
    for (int axis = 0; axis < 3; ++axis) {
        words.tangent[axis] = quantise(spline.a[axis], c.kCoefFrac, c.kCoefBits);
        words.normal[axis] = quantise(spline.b[axis], c.kCoefFrac, c.kCoefBits);
        words.advance[axis] = quantise(spline.c[axis], c.kCoefFrac, c.kCoefBits);
    }
}

template <class C>
inline void curve_words(const ref::TablePiece& piece, int step_exponent, const C& c,
                        SegmentWords<C>& words) {
    words.kind = SegmentKind::kTable;
    const auto rows = piece.rows(std::ldexp(1.0, step_exponent));
    for (const auto& [field, row] : piece.table->bus) {
        const int frac = c.kCoefBits + piece.table->rows.at(row).fraction;
        const int axes = piece.table->rows.at(row).of_axis ? 3 : 1;
        const ref::BusPlace place = ref::bus_place(field);
        for (int axis = 0; axis < axes; ++axis) {
            const std::int64_t word =
                quantise(rows.at(row)[static_cast<std::size_t>(axis)], frac, c.kCoefBits);
            if (place.further()) {
                detail::set_further(words.further, place.number + axis, word);
            } else if (place.field == "theta") {
                words.theta = word;
            } else {
                (place.field == "tangent"  ? words.tangent
                 : place.field == "normal" ? words.normal
                                           : words.advance)[axis] = word;
            }
        }
    }
}

/// @throws std::range_error, as quantise() and whole()
template <class C>
inline SegmentWords<C> to_words(const ref::Segment& segment, const C& c = C()) {
    SegmentWords<C> words;
    words.length = whole(segment.length, kBusLengthBits);
    std::visit([&](const auto& curve) { curve_words(curve, segment.step_exponent, c, words); },
               segment.curve);
    words.step_exponent = segment.step_exponent;
    words.ticks = segment.ticks;
    words.last = segment.last;
    for (int axis = 0; axis < c.kAxes; ++axis) {
        const bool aux = axis >= 3;
        const std::size_t a = static_cast<std::size_t>(aux ? axis - 3 : 0);
        const double start = aux ? segment.aux_start[a] : segment.start[axis];
        const double end = aux ? segment.aux_end[a] : segment.end[axis];
        words.start[axis] = quantise(start, c.kGuardBits, c.kFineBits);
        words.end[axis] = quantise(end, c.kGuardBits, c.kFineBits);
        if (aux) words.advance[axis] = quantise(segment.aux_advance[a], c.kCoefFrac, c.kCoefBits);
    }
    return words;
}

/// Copies a piece, which has integers already.
inline StopStep to_words(const ref::StopStep& step, bool last) {
    return {static_cast<std::int32_t>(step.ticks), step.change, last};
}

inline ProfileWords to_words(const ref::ProfilePiece& piece) {
    ProfileWords words;
    words.ticks = static_cast<std::int32_t>(piece.ticks);
    words.time_exponent = piece.time_exponent;
    words.exponent = piece.exponent;
    words.final = piece.final;
    words.ds = whole(piece.ds, kBusLengthBits);
    for (std::size_t i = 0; i < 3; ++i) {
        words.c[i] = piece.c[i];
    }
    return words;
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
