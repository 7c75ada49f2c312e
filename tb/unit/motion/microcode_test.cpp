// SPDX-License-Identifier: Apache-2.0
// Microcode of rtl/motion_interpolator.sv that is not its own, or not as it was made: it is
// refused, or draws nothing that the kernel would not draw. Data that change are not found out:
// what they do is counted here.
#include <gtest/gtest-spi.h>

#include "hls/instruction.hpp"
#include "hls/registers/registers.h"
#include "rtl/engine/compiler/motion_program.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/microcode/engine_memories.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

constexpr std::uint32_t kRefused = CURVECORE_STATE_MOTION_NO_SAMPLE;
constexpr int kPatience = 1 << 17;  // clocks until it is refused

class Microcode : public MotionInterpolator {
  protected:
    Microcode() { dut_.limit_cycles(~std::uint64_t{0}); }

    assembler::Assembly made_for_core(const sysc::CoreParameters& core,
                                      const assembler::QueueWords& queues) {
        return assembler::motion_program(core, queues, RTL_DIR "/..");
    }
    assembler::Assembly own() { return made_for_core(core_, queues_); }

    std::uint32_t& instruction(std::size_t place) { return memories_.instruction(place); }
    std::uint16_t& limb(int copy, std::size_t place) { return memories_.limb(copy, place); }

    /// Loads programs, and begins anew.
    void load(const assembler::Assembly& from) {
        memories_.load(from, own_.size());
        start_afresh();
    }

    EngineMemories memories_{"motion_interpolator.g_engine.u_motion.u_engine"};
    const assembler::QueueWords queues_{1024, 256};
    const assembler::Assembly own_ = own();
};

TEST_F(Microcode, OfOtherParametersIsRefused) {
    struct Other {
        const char* what;
        int sysc::CoreParameters::*value;
        int is;
    };
    const Other others[] = {{"Order", &sysc::CoreParameters::order, 5},
                            {"Order", &sysc::CoreParameters::order, 9},
                            {"CoefBits", &sysc::CoreParameters::coef_bits, 35},
                            {"PositionBits", &sysc::CoreParameters::position_bits, 31},
                            {"GuardBits", &sysc::CoreParameters::guard_bits, 9},
                            {"AuxAxes", &sysc::CoreParameters::aux_axes, 1},
                            {"Splines", &sysc::CoreParameters::splines, 0},
                            {"Mode", &sysc::CoreParameters::mode, 0}};
    std::vector<std::pair<std::string, assembler::Assembly>> foreign;
    for (const Other& other : others) {
        sysc::CoreParameters core = core_;
        ASSERT_NE(core.*other.value, other.is) << other.what;
        core.*other.value = other.is;
        foreign.emplace_back(other.what, made_for_core(core, queues_));
    }
    sysc::CoreParameters larger = core_;  // a store of 4,096 instructions
    larger.order = 12;
    larger.splines = 0;
    foreign.emplace_back("the store", made_for_core(larger, queues_));
    foreign.emplace_back("rates", assembler::motion_program(core_, queues_, RTL_DIR "/..", 29));
    foreign.emplace_back("SegmentQueueWords", made_for_core(core_, {2048, 256}));
    foreign.emplace_back("ProfileQueueWords", made_for_core(core_, {1024, 512}));
    for (const auto& [what, program] : foreign) {
        load(program);
        this->program(pieces(1, 10, 20, 40, 3 << 16));
        requesting_ = true;
        for (int n = 0; n < 5000 && !HasFailure(); ++n) clock();
        EXPECT_NE(dut_->fault_o & kRefused, 0U) << what;  // and others, of words
        EXPECT_EQ(requested_, 0) << what;
    }
    load(own_);
    program(pieces(1, 10, 20, 40, 3 << 16));
    fill();
    run();
}

TEST_F(Microcode, ThatSaysNothingIsRefused) {
    assembler::Assembly silent(own_.size());
    silent.label("here");
    silent.branch("here");
    silent.finish();
    load(silent);
    requesting_ = true;
    for (int n = 0; n < kPatience && !HasFailure(); ++n) clock();
    EXPECT_EQ(dut_->fault_o, 0U);
    for (int n = 0; n < 100 && !HasFailure(); ++n) clock();
    EXPECT_EQ(dut_->fault_o, kRefused);
    EXPECT_EQ(requested_, 0);

    load(assembler::Assembly(own_.size()));  // no instruction
    for (int n = 0; n < 100 && !HasFailure(); ++n) clock();
    EXPECT_EQ(dut_->fault_o, kRefused);
}

// A reset leaves the data as they are: what a program wrote is anything, and the next one is drawn.
TEST_F(Microcode, FindsAnythingInItsWordsAtAReset) {
    const std::vector<std::int16_t> at_first = own_.memory();
    std::size_t spoilt = 0;
    for (std::uint32_t round = 0; round < 4 && !HasFatalFailure(); ++round) {
        start_afresh();
        program(pieces(round, 10, 5, 20, 3 << 16));
        fill();
        run();
        for (std::size_t n = 0; n < at_first.size(); ++n) {
            if (limb(0, n) == static_cast<std::uint16_t>(at_first[n])) continue;
            limb(0, n) = limb(1, n) = static_cast<std::uint16_t>(random_() & 0x7fff);
            ++spoilt;
        }
    }
    EXPECT_GT(spoilt, 400U);
}

// A sample goes through all segments without length that there are; a queue of them alone would not
// cover a stop, which is a fault.
TEST_F(Microcode, GoesThroughAQueueOfSegmentsWithoutLength) {
    const std::vector<hls::ProfileWords> tick = pieces(1, 10, 20, 40, 3 << 16);
    MixedSegments shapes(core_, 5, kMaxStepExponent);
    std::int64_t length = 0;
    for (const hls::ProfileWords& piece : tick) length += piece.ds;
    std::vector<RunSegment> segments =
        chain(shapes, length, std::int64_t{1} << (kMaxStepExponent + hls::kPathFrac));
    const int frames = queues_.segments / 17 * 2 / 3;
    RunSegment none = segments[1];
    none.length = 0;
    segments.insert(segments.begin() + 1, static_cast<std::size_t>(frames), none);
    program(tick, segments);
    fill();
    std::int64_t most = 0;  // clocks without a sample
    std::int64_t since = 0;
    std::int64_t samples = 0;
    run([&] {
        since = samples_ > samples || samples_ == 0 ? 0 : since + 1;
        samples = samples_;
        most = std::max(most, since);
    });
    std::printf("%d segments without length: no sample for %d clocks\n",
                static_cast<int>(dut_->empty_segments_o), static_cast<int>(most));
    EXPECT_GE(dut_->empty_segments_o, frames);
    EXPECT_LT(most, frames * 400);
}

// A bit of an instruction changes while a program is drawn, or before.
TEST_F(Microcode, ThatChangesDrawsNothingFromThenOn) {
    const int changes = cases(40, 500);
    int found = 0;
    for (int n = 0; n < changes && !HasFatalFailure(); ++n) {
        load(own_);
        program(pieces(static_cast<std::uint32_t>(n), 10, 20, 40, 3 << 16));
        requesting_ = true;
        const std::size_t place = random_() % own_.placed().size();
        const std::uint64_t when = random_() % 60'000;
        std::int64_t more = 0;  // samples behind it
        for (std::uint64_t at = 0; at < when + 60'000 && !HasFatalFailure(); ++at) {
            if (at == when) instruction(place) ^= std::uint32_t{1} << random_() % 32;
            const std::int64_t before = samples_;
            clock();
            ASSERT_TRUE(dut_->fault_o == 0 || dut_->fault_o == kRefused) << dut_->fault_o;
            if (dut_->fault_o != 0) more += samples_ - before;
        }
        ASSERT_LE(more, 16);  // those that were whole
        found += dut_->fault_o != 0 ? 1 : 0;
    }
    std::cout << changes << " changes, " << found << " of them in what was executed\n";
    EXPECT_GT(found, changes / 4);
}

// A bit of a data word in one of its two copies changes, of any word: nothing finds it out but what
// checks the words. The motion goes on as it was, goes wrong, is at fault, or stops, which is late.
TEST_F(Microcode, WhoseDataChangeIsNotRefused) {
    const int changes = cases(10, 500);
    int same = 0;
    int wrong = 0;
    int faults = 0;
    int stops = 0;
    for (int n = 0; n < changes; ++n) {
        load(own_);
        program(pieces(static_cast<std::uint32_t>(n), 10, 20, 40, 3 << 16));
        requesting_ = true;
        const std::size_t place = random_() % own_.memory().size();
        const int copy = static_cast<int>(random_() % 2);
        const std::uint64_t when = random_() % 60'000;
        std::int64_t before = 0;
        testing::TestPartResultArray differences;
        {
            const testing::ScopedFakeTestPartResultReporter seen(
                testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD,
                &differences);
            for (std::uint64_t at = 0; at < when + 100'000 && differences.size() == 0; ++at) {
                if (at == when)
                    limb(copy, place) ^= static_cast<std::uint16_t>(1 << random_() % 16);
                if (at == when + 50'000) before = samples_;
                clock();
            }
        }
        if (dut_->fault_o != 0) {
            ++faults;
        } else if (differences.size() > 0) {
            ++wrong;
        } else {
            ++(samples_ > before ? same : stops);
        }
    }
    std::cout << "of " << changes << " changes " << same << " change nothing, " << wrong
              << " a sample, " << faults << " are faults, " << stops << " stop the samples\n";
    EXPECT_GT(same, changes / 2);
}

}  // namespace
}  // namespace curvecore::tb
