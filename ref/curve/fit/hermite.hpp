// SPDX-License-Identifier: Apache-2.0
// Polynomials from their ends: position, first and second derivative.
#pragma once

#include <array>

#include "ref/curve/cubic.hpp"

namespace curvecore::ref {

/// A piece of a spline over h > 0 of its parameter t; derivatives are by t.
///
/// | field          | symbol    | unit            |
/// |----------------|-----------|-----------------|
/// | h              | h, V      | that of t       |
/// | start, end     | y0, y1    | length          |
/// | start_, end_d1 | y0', y1'  | length / t      |
/// | start_, end_d2 | y0'', y1''| length / t^2    |
struct HermitePiece {
    double h = 1;
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    Vec3 start_d1 = Vec3::Zero();
    Vec3 end_d1 = Vec3::Zero();
    Vec3 start_d2 = Vec3::Zero();
    Vec3 end_d2 = Vec3::Zero();
};

/// The cubic with the given slopes, u = t / h ([Petrakov] (2), "end conditions 1").
inline Cubic cubic_of_slopes(const HermitePiece& piece) {
    const Vec3 chord = piece.end - piece.start;
    const Vec3 out = piece.h * piece.start_d1;
    const Vec3 in = piece.h * piece.end_d1;
    return {(out - chord) + (in - chord), 3 * chord - 2 * out - in, out, piece.start};
}

/// The cubic with the given second derivatives M ("end conditions 2"): [Petrakov] (3)-(5) with the
/// divided difference [y0, y1] = (y1 - y0) / h where the paper prints a slope:
///
///     y0' = [y0, y1] - h M0 / 3 - h M1 / 6
inline Cubic cubic_of_moments(const HermitePiece& piece) {
    const Vec3 start = piece.h * piece.h / 2 * piece.start_d2;
    const Vec3 end = piece.h * piece.h / 2 * piece.end_d2;
    const Vec3 chord = piece.end - piece.start;
    return {(end - start) / 3, start, chord - (2 * start + end) / 3, piece.start};
}

/// Control points of the quintic with the given first and second derivatives, which [Petrakov]
/// announces without a formula; the same curve as y0 H0 + h y0' H1 + h^2 y0'' H2 + ..
inline std::array<Vec3, 6> quintic_points(const HermitePiece& piece) {
    const double h = piece.h;
    const Vec3 out = h / 5 * piece.start_d1;
    const Vec3 in = h / 5 * piece.end_d1;
    return {piece.start,
            piece.start + out,
            piece.start + 2 * out + h * h / 20 * piece.start_d2,
            piece.end - 2 * in + h * h / 20 * piece.end_d2,
            piece.end - in,
            piece.end};
}

}  // namespace curvecore::ref
