// SPDX-License-Identifier: Apache-2.0
// A table's curve that an active comment asks for, on the way of the move behind it:
//
//     (curve, clothoid, T=1 0 0, N=0 1 0, kappa=0.05, sigma=0.001, length=40)
//     G1 X31.03 Y19.92 F600
//
// The table's rows have the values of the start, where the path is a unit of the program long: a
// kappa is in 1 / mm, or in 1 / inch after G20. One number of a row of three axes is all three's.
#pragma once

#include <string>

#include "ref/curve/drawn/table_piece.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

/// | field  | unit            |
/// |--------|-----------------|
/// | piece  | program's units |
/// | length | program's units |
struct NamedCurve {
    TablePiece piece;
    double length = 0;
    int line = 0;  // of the comment
};

/// Reads what stands behind `(curve,`. @param table of the core; null: there is none
/// @throws InputError: another table's name; a row that the table has not, twice or without its
/// number; no length
NamedCurve read_named_curve(const std::string& text, const CurveTable* table, const Place& place);

}  // namespace curvecore::ref
