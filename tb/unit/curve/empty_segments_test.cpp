// SPDX-License-Identifier: Apache-2.0
// The count of segments without a length saturates, in either build.
#include "tb/support/bench/curve_core_bench.hpp"

namespace curvecore::tb {
namespace {

using EmptySegments = CurveCoreBench<LegalSegments, 1>;

TEST_F(EmptySegments, AreCountedUpTo65535) {
    RunSegment empty = LegalSegments(core_, 5).whole(4, 1);
    empty.length = 0;
    for (int n = 0; n < 65540; ++n) add(empty);
    add(LegalSegments(core_, 5).whole(4, 1));
    requests_.push_back(10);
    expected_.push_back(predict(10, [] { FAIL(); }));
    ASSERT_NO_FATAL_FAILURE(drain([] { return true; }));
    EXPECT_EQ(kernel_.empty_segments(), 65540);
    EXPECT_EQ(dut_->empty_segments_o, 65535);
}

}  // namespace
}  // namespace curvecore::tb
