// SPDX-License-Identifier: Apache-2.0
// A bench for rtl/motion_system.sv with a host and drives, and a part to draw.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tb/support/bench/register_host.hpp"

namespace curvecore::tb {

/// The part; CURVECORE_PART: another file of tb/data (scripts/campaign.sh: the demo). It has no
/// stop branches, which are too many words for short queues.
inline Part part_to_draw() {
    const char* part = std::getenv("CURVECORE_PART");
    return part == nullptr ? Part("pulses.ngc", ref::Holds::kBranches)
                           : Part(part, ref::Holds::kBounds);
}

class MotionSystem : public testing::Test {
  protected:
    /// Checks that the drives have counted the part, and that the registers agree, from `start` on.
    void expect_drawn(const std::vector<int64_t>& start = {0, 0, 0}) {
        EXPECT_EQ(host_.state() & kFaults, 0U);
        for (int a = 0; a < kSystemAxes; ++a) {
            EXPECT_EQ(host_.drive(a).complaint(), "") << "axis " << a;
            EXPECT_EQ(host_.drive(a).count(), start[a] + part_.end(a)) << "axis " << a;
        }
        expect_counted();
    }
    void expect_counted() {
        for (int a = 0; a < kSystemAxes; ++a) {
            const uint32_t axis = static_cast<uint32_t>(a) * CURVECORE_AXIS_STRIDE;
            EXPECT_EQ(static_cast<int32_t>(host_.read(CURVECORE_AXIS_STEPS + axis)),
                      host_.drive(a).count());
        }
    }
    std::vector<int64_t> counts() const {
        std::vector<int64_t> all;
        for (int a = 0; a < kSystemAxes; ++a) all.push_back(host_.drive(a).count());
        return all;
    }
    int64_t steps() const {
        int64_t sum = 0;
        for (int a = 0; a < kSystemAxes; ++a) sum += host_.drive(a).steps();
        return sum;
    }
    void clear_faults() { host_.write(CURVECORE_STATE, kFaults); }

    /// Turns the machine on and draws for so many tenths of a millisecond.
    void begin(int64_t tenths) {
        host_.prepare(part_);
        RegisterHost::Sent sent;
        host_.draw_for(tenths, part_, sent);
        ASSERT_TRUE(host_.is(CURVECORE_STATE_ACTIVE_MASK));
    }

    std::mt19937 random_{1};
    Part part_ = part_to_draw();
    RegisterHost host_;
};

}  // namespace curvecore::tb
