// SPDX-License-Identifier: Apache-2.0
// Default depths of a core's queues in words (SegmentQueueWords, ProfileQueueWords): the defaults
// of rtl/motion_interpolator.sv, to which a test holds them. Boards state theirs. The planner needs
// them, since what is queued must outlast a stop.
#pragma once

namespace curvecore::ref {

constexpr int kSegmentQueueWords = 4096;
constexpr int kProfileQueueWords = 4096;

/// Queues of the program's own boards, words of 48 bits: the deepest of rtl/motion_interpolator.sv,
/// so that they draw plans for any queues.
constexpr int kBoardSegmentWords = 65536;
constexpr int kBoardProfileWords = 4096;

}  // namespace curvecore::ref
