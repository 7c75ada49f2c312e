// SPDX-License-Identifier: Apache-2.0
// No sample of a board with the engine is late at the shortest period that the planner takes it
// for, in RTL: the programs that engine_time_test.cpp has on the twin. A late sample is a fault.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "hls/registers/board_facts.h"
#include "ref/text/text_file.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "tb/support/bench/register_host.hpp"
#include "tb/support/microcode/busy_program.hpp"
#include "tb/support/microcode/engine_memories.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

constexpr std::uint16_t kDigest = 0x5a17;
constexpr uint32_t kLate = CURVECORE_STATE_LATE_MASK;

ref::CoreParameters core_of_board() {
    ref::CoreParameters core;
    core.build = ref::Build::kEngine;
    core.splines = 1;
    core.mode = 1;
    return core;
}

/// The board, which draws words as they come. Its axes' whole range is a quarter of a step.
class BusyBoard {
  public:
    explicit BusyBoard(const std::string& tree = RTL_DIR "/..") {
        const assembler::Assembly made = assembler::motion_program(
            core_of_board(), {CFG_SegmentQueueWords, CFG_ProfileQueueWords}, tree,
            16 + CFG_PeriodLog2);
        memories_.load(made, made.size());
    }
    void begin(const TimeCase& of) {
        for (uint32_t a = 0; a < kSystemAxes; ++a) {
            host_.write(CURVECORE_AXIS_SCALE_LO + a * CURVECORE_AXIS_STRIDE, 1 << 14);
            host_.write(CURVECORE_AXIS_SCALE_HI + a * CURVECORE_AXIS_STRIDE, 0);
        }
        host_.write(CURVECORE_OVERRIDE, 65536);
        host_.write(CURVECORE_TIMING, static_cast<uint32_t>(of.samples_per_tick_log2));
        host_.write(CURVECORE_HOLD_ACCELERATION, 1 << 12);
        host_.write(CURVECORE_HOLD_SLOPE, 1 << 30);
        host_.write(CURVECORE_STOP_TICKS, static_cast<uint32_t>(of.stop_ticks()));
        const std::uint16_t of_board =
            curvecore_board_digest(host_.read(CURVECORE_CAPABILITY), host_.read(CURVECORE_CORE),
                                   static_cast<std::uint32_t>(kSystemPeriod), CFG_ClockHertz);
        host_.write(CURVECORE_DIGEST, kDigest ^ of_board);
        EXPECT_TRUE(host_.write(CURVECORE_REFERENCE, kEveryAxis));
        EXPECT_TRUE(host_.write(CURVECORE_CONTROL, kEnable));
    }
    /// Writes words for so many samples, wherever there is room, or one of each stream a sample.
    template <class Next>
    void draw(int samples, bool slowly, Next&& next) {
        const int64_t end = host_.now() + samples * kSystemPeriod;
        const uint32_t at_once = slowly ? 1 : 128;
        while (host_.now() < end && host_.is(CURVECORE_STATE_ENABLED_MASK)) {
            const uint32_t room = host_.read(CURVECORE_ROOM);
            push(CURVECORE_SEGMENT_LO, kSegments, std::min(at_once, room & 0xffff), next);
            push(CURVECORE_PROFILE_LO, kPieces, std::min(at_once, room >> 16), next);
            active_ += host_.is(CURVECORE_STATE_ACTIVE_MASK) ? 1 : 0;
            ++looks_;
            host_.clocks(kSystemPeriod / (slowly ? 1 : 8));
        }
    }
    RegisterHost& host() { return host_; }
    double active() const { return static_cast<double>(active_) / looks_; }

  private:
    template <class Next>
    void push(uint32_t address, Stream stream, uint32_t count, Next&& next) {
        while (count-- > 0 && host_.push(address, next(stream))) {
        }
    }

    RegisterHost host_;
    EngineMemories memories_{"motion_system.u_sources.u_motion.g_engine.u_motion.u_engine"};
    int active_ = 0;
    int looks_ = 0;
};

TEST(SystemTime, NoSampleIsLateInTheLeastPeriod) {
    int n = 0;
    int starved = 0;
    each_case([&](const TimeCase& of) {
        if (of.mode != core_of_board().mode || n++ % cases(5, 1) != 0) return;
        ASSERT_LE(
            sysc::least_period_clocks(core_of_board(), of.spline, 1 << of.samples_per_tick_log2),
            kSystemPeriod);
        BusyBoard board;
        BusyProgram program(core_of_board(), of, kDigest, 1);
        board.begin(of);
        std::mt19937_64 random(2);
        for (int k = 0; k < cases(100, 500); ++k) {
            const bool slowly = of.slow_host && k >= 40;  // with full queues
            board.draw(4, slowly, [&](Stream s) { return program.next(s); });
            if (!of.moves) continue;
            board.host().write(CURVECORE_CONTROL, kEnable | (random() % 16 == 0 ? kHold : 0));
            board.host().write(CURVECORE_OVERRIDE, static_cast<uint32_t>(65536 - random() % 3000));
        }
        EXPECT_EQ(board.host().state() & kFaults, 0U) << text(of);
        if (of.slow_host) {
            starved += board.host().is(CURVECORE_STATE_UNDERRUN_MASK) ? 1 : 0;
        } else {
            EXPECT_GT(board.active(), 0.5) << text(of);
        }
    });
    EXPECT_GT(starved, 0);
}

/// Programs that take some 5,000 clocks more for each piece of a profile.
class SlowPrograms {
  public:
    SlowPrograms() {
        namespace fs = std::filesystem;
        for (const char* part : {"/rtl/engine/programs", "/ref/curves"}) {
            fs::create_directories(tree_ + part);
            fs::copy(RTL_DIR "/.." + std::string(part), tree_ + part);
        }
        const std::string path = tree_ + "/rtl/engine/programs/path.asm";
        std::string text = ref::read_text_file(path);
        const std::string begins = "\npiece_begins:\n";
        text.insert(text.find(begins) + begins.size(),
                    "  delay = 512\n  loop\n  test rate * rate\n  delay = delay - 1\n"
                    "  test rate * rate\n  test delay + 0\n  if zero go to over\n"
                    "  repeat 512 times\nover:\n");
        text.insert(text.find("\nword "), "\nword delay");
        std::ofstream(path) << text;
    }
    ~SlowPrograms() { std::filesystem::remove_all(tree_); }
    const std::string& tree() const { return tree_; }

  private:
    std::string tree_ = testing::TempDir() + "slow_programs_" + std::to_string(getpid());
};

TEST(SystemTime, ASampleThatIsLateTurnsTheMachineOff) {
    TimeCase of;
    of.mode = core_of_board().mode;
    BusyBoard board(SlowPrograms().tree());
    BusyProgram program(core_of_board(), of, kDigest, 1);
    board.begin(of);
    board.draw(400, false, [&](Stream s) { return program.next(s); });
    EXPECT_EQ(board.host().state() & kFaults, kLate);
    EXPECT_FALSE(board.host().is(CURVECORE_STATE_ENABLED_MASK));
}

}  // namespace
}  // namespace curvecore::tb
