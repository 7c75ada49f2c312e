// SPDX-License-Identifier: Apache-2.0
// A machine whose engine has programs for another one: it goes off when it comes on, no axis moves,
// and the fault says why.
#include <gtest/gtest.h>

#include "rtl/engine/compiler/motion_program.hpp"
#include "tb/support/bench/register_host.hpp"
#include "tb/support/microcode/engine_memories.hpp"

namespace curvecore::tb {
namespace {

constexpr uint32_t kPosition = kEnable | CURVECORE_CONTROL_POSITION_MASK;
constexpr uint32_t kFault = CURVECORE_PUT(STATE_MOTION, CURVECORE_STATE_MOTION_NO_SAMPLE);
constexpr int kPatience = 1 << 17;  // clocks
constexpr int kRateBits = 16 + CFG_PeriodLog2;

class SystemMicrocode : public testing::Test {
  protected:
    /// The programs that it is made for, or of other widths.
    static assembler::Assembly programs(int position_bits = 32) {
        ref::CoreParameters core;
        core.splines = 1;
        core.mode = 1;
        core.position_bits = position_bits;
        return assembler::motion_program(core, {CFG_SegmentQueueWords, CFG_ProfileQueueWords},
                                         RTL_DIR "/..", kRateBits);
    }
    void load(const assembler::Assembly& from) { memories_.load(from, programs().size()); }
    /// Turns the drives on; returns whether they came on.
    bool begin(uint32_t control) {
        for (uint32_t a = 0; a < kSystemAxes; ++a) {
            const uint32_t axis = a * CURVECORE_AXIS_STRIDE;
            EXPECT_TRUE(host_.write(CURVECORE_AXIS_SCALE_LO + axis, 0));
            EXPECT_TRUE(host_.write(CURVECORE_AXIS_SCALE_HI + axis, 1 << 8));
        }
        EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
        return host_.write(CURVECORE_CONTROL, control);
    }
    void push(int steps) {
        for (int a = 0; a < kSystemAxes; ++a) {
            host_.write(CURVECORE_SAMPLE, static_cast<uint32_t>(steps) << 8);
        }
    }
    int64_t steps() const {
        int64_t sum = 0;
        for (int a = 0; a < kSystemAxes; ++a) sum += host_.drive(a).steps();
        return sum;
    }

    RegisterHost host_;
    EngineMemories memories_{"motion_system.u_sources.u_motion.g_engine.u_motion.u_engine"};
};

TEST_F(SystemMicrocode, OfItsOwnMovesTheAxes) {
    load(programs());
    ASSERT_TRUE(begin(kPosition));
    for (int n = 0; n < 20; ++n) push(n);
    host_.samples(20);
    EXPECT_GT(steps(), 30);
    EXPECT_EQ(host_.state() & CURVECORE_STATE_MOTION_MASK, 0U);
}

TEST_F(SystemMicrocode, OfAnotherMachineMovesNothing) {
    load(programs(31));
    for (const uint32_t control : {kPosition, kEnable}) {
        begin(control);  // its programs run while it is on
        host_.clocks(100);
        EXPECT_FALSE(host_.is(CURVECORE_STATE_ENABLED_MASK));
        EXPECT_TRUE(host_.is(kFault));
        for (int n = 0; n < 20; ++n) push(n);
        host_.samples(20);
        EXPECT_EQ(steps(), 0);
        EXPECT_TRUE(host_.write(CURVECORE_STATE, kFaults));
    }
}

// Its own, but for the instruction that says so.
TEST_F(SystemMicrocode, ThatSaysNothingMovesNothing) {
    load(programs());
    std::size_t says = 0;
    const std::vector<assembler::Placed> placed = programs().placed();
    while (placed[says].instruction.op != engine::Op::kOut) ++says;
    memories_.instruction(says) = encode(engine::Instruction());
    ASSERT_TRUE(begin(kPosition));
    for (int n = 0; n < 20; ++n) push(n);
    host_.clocks(kPatience - 2000);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_ENABLED_MASK));
    host_.clocks(2000);
    EXPECT_FALSE(host_.is(CURVECORE_STATE_ENABLED_MASK));
    EXPECT_TRUE(host_.is(kFault));
    EXPECT_EQ(steps(), 0);
}

}  // namespace
}  // namespace curvecore::tb
