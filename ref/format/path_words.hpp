// SPDX-License-Identifier: Apache-2.0
// Sizes of words of path length and of frames, defined here alone. C++14, for hls/.
#pragma once

namespace curvecore {
namespace ref {

constexpr int kPathFrac = 16;  // a path quantum is 2^-16 length unit
constexpr double kQuantaPerUnit = 1 << kPathFrac;
constexpr double kQuantum = 1 / kQuantaPerUnit;  // units
constexpr int kBusLengthBits = 44;    // a segment's length, a piece's ds: unsigned, quanta
constexpr int kMaxStepExponent = 27;  // an integration step is 2^k length units, k in [0, 27]
constexpr int kProgramBits = 63;      // the path of a whole program, so that differences are signed

/// Number of 48-bit bus words (hls/words.hpp):
constexpr int kAxisBusWords = 3;     // an auxiliary axis of a segment
constexpr int kProfileBusWords = 5;  // a piece
constexpr int segment_bus_words(int aux_axes) { return 17 + kAxisBusWords * aux_axes; }

/// Stop branches (hls/stop_schedule.hpp). A branch is due this many ticks after its piece begins:
/// more than are ever on their way from the time scaler to the path generator.
constexpr int kStopLead = 32;
constexpr int kStopSteps = 256;     // steps of a branch that the core keeps
constexpr int kStopWaitBits = 20;   // ticks from one branch to the next
constexpr int kStepTicksBits = 11;  // bits of a step's ticks

/// Rate of time, 2^-16, from which on a stop takes a branch: below, the bounds are as quick.
constexpr int kBranchRate = 9 << 12;

/// Rate of time, 2^-16, from which on the time scaler (hls/time_scaler.hpp) takes 2^-3 of its
/// bounds.
constexpr int kFineRate = 7 << 13;
constexpr int kFineShift = 3;

/// Outputs that follow the speed: the way of a sample at which they are whole, length units, is
/// between these (hls/path_outputs.hpp). No way is longer.
constexpr double kLeastWay = 1.0 / (1 << 8);
constexpr double kGreatestWay = 1 << 24;

/// Bound of a path, length units.
constexpr double kLongestSegment = 1LL << (kBusLengthBits - kPathFrac);
constexpr double kLongestProgram = 1LL << (kProgramBits - kPathFrac);

}  // namespace ref
}  // namespace curvecore
