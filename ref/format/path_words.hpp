// SPDX-License-Identifier: Apache-2.0
// Words of path length: the one place of their sizes. C++14, for hls/.
#pragma once

namespace curvecore {
namespace ref {

constexpr int kPathFrac = 16;       // a path quantum is 2^-16 length unit
constexpr int kBusLengthBits = 44;  // a segment's length, a piece's ds: unsigned, quanta
constexpr int kProgramBits = 63;    // the path of a whole program, so that differences are signed

/// In length units; a path reaches less.
constexpr double kLongestSegment = 1LL << (kBusLengthBits - kPathFrac);
constexpr double kLongestProgram = 1LL << (kProgramBits - kPathFrac);

}  // namespace ref
}  // namespace curvecore
