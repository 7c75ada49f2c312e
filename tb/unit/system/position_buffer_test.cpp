// SPDX-License-Identifier: Apache-2.0
// rtl/bus/position_buffer.sv: positions of its samples in both of its memories. What is taken, and
// when: tb/formal/bus/position_buffer_formal.sv.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vposition_buffer.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {
namespace {
using namespace sysc;

// As rtl/pulse/place_scaler.sv: an axis' position is wanted from two clocks behind its number on;
// by the engine, from one on, but not behind a write.
TEST(PositionBuffer, ShowsThePositionsOfItsSamples) {
    ClockedDut<Vposition_buffer> dut;
    dut.limit_cycles(UINT64_MAX);
    dut->write_i = 0;
    dut->ends_i = 0;
    dut->empty_i = 0;
    dut->ready_i = 0;
    dut->axis_i = 0;
    dut.reset();
    std::mt19937 random{1};
    std::deque<unsigned> positions;  // of samples, and of a part of one
    int since = 0;                   // clocks that it was not written
    int offered = 0;                 // clocks of this sample's axis
    int axis = 0;
    int samples = 0;
    int met = 0;  // writes in the clocks of a new axis
    for (int n = 0; n < 400'000; ++n) {
        dut->write_i = since >= 2 && random() % 3 == 0;
        dut->data_i = random();
        dut->axis_i = axis;
        dut.settle();
        const bool defined = CFG_Holds == 1 || since > 0;
        if (dut->write_i && dut->ready_o) positions.push_back(dut->data_i);
        since = dut->write_i ? 0 : since + 1;
        offered = dut->valid_o ? offered + 1 : 0;
        if (offered == 1 && dut->write_i) ++met;
        if (defined && offered > 1 + CFG_Holds) {
            ASSERT_EQ(dut->position_o, positions[axis]) << axis << ", clock " << n;
        }
        const bool next = offered > 4 && random() % 8 == 0;
        dut->ready_i = next && axis == CFG_Axes - 1;
        if (dut->ready_i) {
            positions.erase(positions.begin(), positions.begin() + CFG_Axes);
            ++samples;
        }
        if (next) {
            axis = (axis + 1) % CFG_Axes;
            offered = 0;
        }
        dut.tick();
    }
    EXPECT_GT(samples, 5'000);
    EXPECT_GT(met, 1'000);
}

}  // namespace
}  // namespace curvecore::tb
