// SPDX-License-Identifier: Apache-2.0
// Places of a spline's words. Segments are loaded to the places of arcs: b and a in order 0 of rows
// 0 2 4 and 1 3 5, c in place of the advance, phi in place of theta.
#pragma once

#include "rtl/serial/program_word.hpp"

namespace curvecore::serial {

// Rows of series; X Y Z in the order of the rows.
constexpr int kLowerQ = 16;
constexpr int kPhi = 17;
constexpr int kQ = 18;
constexpr int kR = 19;
constexpr int kDphi = 20;
constexpr int kDP = 21;
constexpr int kV = 22;
constexpr int kW = 25;
constexpr int kDV = 28;
constexpr int kX[3] = {0, 2, 4};  // rows of arcs' displacements: the same program samples them

// Words of an axis, and others.
constexpr Address of_axis(int axis, int place) { return {(1 + 2 * axis) << 4 | place}; }
constexpr Address a_of(int axis) { return of_axis(axis, 0); }
constexpr Address b_of(int axis) { return in_row(2 * axis); }
constexpr Address three_a(int axis) { return of_axis(axis, 1); }
constexpr Address two_c(int axis) { return of_axis(axis, 2); }
constexpr Address step_a(int axis) { return of_axis(axis, 3); }
constexpr Address six_a(int axis) { return of_axis(axis, 4); }
constexpr Address step_b(int axis) { return of_axis(axis, 5); }
constexpr Address slope(int axis) { return of_axis(axis, 6); }
constexpr Address mean(int axis) { return of_axis(axis, 7); }
constexpr Address e_of(int axis) { return of_axis(axis, 8); }
constexpr Address f_of(int axis) { return of_axis(axis, 9); }
constexpr Address kLowerV{0x1a};
constexpr Address kMoved{0x1b};
constexpr Address kNorm{0x1c};
constexpr Address kSpeedWord{0x1d};  // m = N phi
constexpr Address kMinusSpeed{0x1e};
constexpr Address kNewton{0x1f};  // z = 1 - m phi
constexpr Address kSquareOfPhi{0x3a};
constexpr Address kCubeOfPhi{0x3b};
constexpr Address kDQ{0x3c};
constexpr Address kSeriesDX[3] = {{0x3d}, {0x3e}, {0x3f}};

/// Powers of two that scale by 2^-shift, 0 unless the scale is made by a shift by CoefBits - 1, or
/// by kLessSix: rtl/serial/scale_words.sv.
enum Scaling { kMovedScale = 0, kSlopeScale = 2, kAScale = 4, kThreeAScale = 6 };
constexpr Address right(Scaling scaling) { return {0xb8 + scaling}; }
constexpr Address left(Scaling scaling) { return {0xb9 + scaling}; }

}  // namespace curvecore::serial
