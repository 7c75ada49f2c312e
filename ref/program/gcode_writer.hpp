// SPDX-License-Identifier: Apache-2.0
// Moves as G-code that the reader reads back as the same moves, to 1e-9 mm; to 1e-6 mm an arc whose
// radii at both ends differ by more than a program in mm may say.
#pragma once

#include <string>
#include <vector>

#include "ref/moves/move.hpp"

namespace curvecore::ref {

/// The modes that all written blocks count on: mm, absolute, XY plane, feed per minute.
constexpr const char* kWrittenModes = "G21 G90 G91.1 G17 G40 G94 G64\n";

/// " X1.5": a word with up to nine decimals.
std::string word(char letter, double value);
/// " F1500", of a feed in mm/s.
std::string feed_word(double feed);
/// " X1 Y2", and " Z3" where it is wanted.
std::string point_words(const Vec3& point, bool with_z);

/// A G5 block of a cubic's control points without its feed; in space with the words Z K R, which
/// are this reader's own.
std::string g5_block(const Bezier& points, bool in_space);
/// A polynomial of any degree as G5.2 .. G5.3, with words behind the first block; the same of Z.
std::string g52_blocks(const std::vector<Vec3>& points, bool in_space, const std::string& words);

/// Blocks, one or more lines each, behind kWrittenModes; the plane is XY again behind them. Words
/// of spindle, tool and coolant are not in moves.
/// @throws InputError, of `file`: a spline with auxiliary axes, a helix in a tilted plane, which no
/// block has
std::string gcode_of(const std::string& file, const std::vector<Move>& moves);

}  // namespace curvecore::ref
