// SPDX-License-Identifier: Apache-2.0
// How many words the queues of the program's boards hold (SegmentQueueWords, ProfileQueueWords of
// rtl/motion_interpolator.sv). The planner needs them, since what is queued must outlast a stop.
#pragma once

namespace curvecore::ref {

constexpr int kSegmentQueueWords = 65536;
constexpr int kProfileQueueWords = 4096;

}  // namespace curvecore::ref
