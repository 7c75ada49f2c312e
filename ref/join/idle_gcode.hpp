// SPDX-License-Identifier: Apache-2.0
// An idle move as G-code: exact where G-code has the curve, or chords by a step or a tolerance.
#pragma once

#include <string>

#include "ref/join/jumps.hpp"

namespace curvecore::ref {

/// | form      | blocks                                                                          |
/// |-----------|---------------------------------------------------------------------------------|
/// | exact     | G5 of every cubic, G5.2 .. G5.3 of every quintic                                |
/// | tolerance | G1 chords that are nowhere farther than `size` from the curve                   |
/// | step      | G1 chords of equal path, at most `size`                                         |
enum class GcodeForm { kExact, kTolerance, kStep };
constexpr std::array<std::string_view, 3> kGcodeFormNames = {"exact", "tolerance", "step"};

struct GcodeChoice {
    GcodeForm form = GcodeForm::kExact;
    double size = 0;  // mm
};

/// Largest number of chords.
constexpr std::size_t kMostChords = 1000000;

/// Returns true if the move lies in a plane of constant Z, which G5 and G5.2 are made for.
bool is_plane(const std::vector<BezierPiece>& pieces);

/// Makes blocks from the start of the move; the feed of each is the speed in its middle. The bound
/// of a tolerance: a chord is off by h^2 max |r''| / 8 at most, and a Bernstein form's second
/// differences bound r''.
/// @throws std::invalid_argument: more than kMostChords
std::string idle_gcode(const PathTable& path, const SpeedCourse& course, const GcodeChoice& choice);

}  // namespace curvecore::ref
