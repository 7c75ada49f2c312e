// SPDX-License-Identifier: Apache-2.0
// Words of path length and frames of words: the one place of their sizes. C++14, for hls/.
#pragma once

namespace curvecore {
namespace ref {

constexpr int kPathFrac = 16;         // a path quantum is 2^-16 length unit
constexpr int kBusLengthBits = 44;    // a segment's length, a piece's ds: unsigned, quanta
constexpr int kMaxStepExponent = 27;  // an integration step is 2^k length units, k in [0, 27]
constexpr int kProgramBits = 63;      // the path of a whole program, so that differences are signed

/// Words of 48 bits on the bus (hls/words.hpp).
constexpr int kAxisBusWords = 3;     // of an auxiliary axis in a segment
constexpr int kProfileBusWords = 5;  // of a piece
constexpr int segment_bus_words(int aux_axes) { return 17 + kAxisBusWords * aux_axes; }

/// Stop branches (hls/stop_schedule.hpp). A branch is due so many ticks after its piece has begun:
/// more than are ever on their way from the time scaler to the path generator.
constexpr int kStopLead = 32;
constexpr int kStopSteps = 256;     // of a branch, that the core keeps
constexpr int kStopWaitBits = 20;   // ticks from one branch to the next
constexpr int kStepTicksBits = 11;  // of a step

/// From the rate 7/8 on, in 2^-16, the time scaler (hls/time_scaler.hpp) takes 2^-3 of its bounds.
constexpr int kFineRate = 7 << 13;
constexpr int kFineShift = 3;

/// In length units; a path reaches less.
constexpr double kLongestSegment = 1LL << (kBusLengthBits - kPathFrac);
constexpr double kLongestProgram = 1LL << (kProgramBits - kPathFrac);

}  // namespace ref
}  // namespace curvecore
