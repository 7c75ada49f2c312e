// SPDX-License-Identifier: Apache-2.0
// Moves as G-code that the reader reads back as the same moves, to 1e-9 mm; to 1e-6 mm for an arc
// whose radii at both ends differ by more than a program in mm may state.
#pragma once

#include <string>
#include <vector>

#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// Modes that all written blocks rely on: mm, absolute, XY plane, feed per minute.
constexpr const char* kWrittenModes = "G21 G90 G91.1 G17 G40 G94 G64\n";

/// Writes " X1.5": a word with up to nine decimals.
std::string word(char letter, double value);
/// Writes " F1500", for a feed in mm/s.
std::string feed_word(double feed);
/// Writes " X1 Y2", with " Z3" if `with_z`.
std::string point_words(const Vec3& point, bool with_z);

/// Writes a G5 block of a cubic's control points without its feed; in space with the words Z K R,
/// which are this reader's own.
std::string g5_block(const Bezier& points, bool in_space);
/// Writes a polynomial of any degree as G5.2 .. G5.3, with words behind the first block; Z as in
/// G5.
std::string g52_blocks(const std::vector<Vec3>& points, bool in_space, const std::string& words);

/// Writes blocks, one or more lines each, behind kWrittenModes; the plane is XY again behind them.
/// Moves have no words of spindle, tool and coolant.
/// @throws InputError, of `file`: a spline with auxiliary axes, a helix in a tilted plane, which no
/// block has
std::string gcode_of(const std::string& file, const std::vector<Move>& moves);

}  // namespace curvecore::ref
