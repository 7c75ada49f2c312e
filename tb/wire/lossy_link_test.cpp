// SPDX-License-Identifier: Apache-2.0
// A program over a network that loses, doubles and delays: every step at the same clock as over a
// good one. All times are in the board's clocks.
#include "tb/wire/lossy_link.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "sysc/wire/wire_options.hpp"
#include "sysc/wire/wire_stream.hpp"

namespace curvecore::sysc {
namespace {

/// Words, in 1.9 s: more than the board's queue of profile words holds.
constexpr const char* kPart =
    "G21 G90 G61 F6000\n"
    "G1 X8 Y1 Z1\nG3 X12 Y5 I0 J4\nG5 X15 Y12 I0 J3 P-2 Q-2\nG3 X9 Y12 Z3 I-3 J0\n"
    "G2 X3 Y12 I-3 J0\nG5 X0 Y5 I0 J-3 P1 Q2\nG3 X4 Y1 I4 J0\nG1 X12\nG3 X12 Y9 I0 J4\n"
    "G2 X12 Y17 Z0 I0 J4\nG1 X20\nG3 X20 Y25 I0 J4\nG1 X4\nG2 X4 Y33 I0 J4\nM2\n";

/// Steps: clock from the first step, axis, direction.
using Steps = std::vector<std::array<std::int64_t, 3>>;

struct Drawn {
    Steps steps;
    bool held = false;
    std::size_t waits = 0;
    LinkFigures figures;
};

Drawn draw(LossyLink& link, Steps& steps) {
    const std::string part = testing::TempDir() + "lossy_part.ngc";
    std::ofstream(part) << kPart;
    Options options;
    options.file = part;
    RemoteMachine machine(link, 1);
    take_board(machine.build(), options);
    WordSource words(options);
    machine.prepare(drives_of(WireOptions(), machine.build().axes), options.unit_mm);
    machine.begin(words.settings(), 0);
    WishQueue wishes;
    WireStream stream(machine, words, wishes, 1);
    EXPECT_EQ(stream.run([] {}), StreamEnd::kDone);
    EXPECT_GT(stream.planned().words, 1500U);
    machine.steps();  // until the last step is out
    const std::int64_t first = steps.empty() ? 0 : steps[0][0];
    for (auto& step : steps) step[0] -= first;
    return {steps, stream.held(), stream.waits().size(), machine.figures()};
}

class LossyLinks : public testing::Test {
  protected:
    static Drawn over(const Network& network) {
        Steps steps;
        LossyLink link(network, [&](const VirtualStep& step) {
            const auto clock = static_cast<std::int64_t>(step.clock);
            steps.push_back({clock, step.axis, step.back ? -1 : 1});
        });
        Drawn drawn = draw(link, steps);
        if (network.lost > 0) {
            EXPECT_GE(static_cast<double>(link.lost()),
                      network.lost * static_cast<double>(drawn.figures.frames));
            EXPECT_GT(link.doubled(), 50U);
            EXPECT_GT(link.late(), 100U);
        }
        return drawn;
    }

    static void SetUpTestSuite() { good_ = over({}); }

    /// A network that loses 10 %, doubles 10 %, and delays 20 % by up to 50 ms.
    static Network bad(unsigned seed) { return {seed, 0.1, 0.1, 0.2}; }

    static void expect_the_same_clocks(unsigned first_seed, unsigned last_seed) {
        for (unsigned seed = first_seed; seed <= last_seed; ++seed) {
            const Drawn drawn = over(bad(seed));
            std::printf("seed %u: %lu frames, %lu repeated, %zu waits\n", seed,
                        drawn.figures.frames, drawn.figures.repeated, drawn.waits);
            std::fflush(stdout);
            EXPECT_TRUE(drawn.steps == good_.steps) << "seed " << seed;
        }
    }

    static Drawn good_;
};
Drawn LossyLinks::good_;

TEST_F(LossyLinks, BadOneChangesNoClock) {
    EXPECT_FALSE(good_.held);
    EXPECT_GT(good_.steps.size(), 40'000U);
    EXPECT_EQ(good_.figures.repeated, 0U);
    expect_the_same_clocks(1, 2);
}

/// A board that slept for 2 s is asked no more than it answers: what waits before it gets less.
/// With all places for frames full, each command would take 0.5 s.
TEST(SlowBoard, IsNotDrownedInQuestions) {
    Network slow;
    slow.frame_s = 2e-3;
    LossyLink link(slow, [](const VirtualStep&) {});
    RemoteMachine machine(link, 1);
    const auto time_of = [&](int commands) {
        const WireClock::time_point begin = link.now();
        for (int n = 0; n < commands; ++n) {
            machine.clear_watchdog();
            machine.finish();
        }
        return std::chrono::duration<double>(link.now() - begin).count();
    };
    const double awake = time_of(40);
    link.sleep(2);
    EXPECT_GT(time_of(1), 2);
    EXPECT_LT(time_of(40), 2 * awake);
}

/// A rate that is set with every turn leaves a slow board no frame for words: a program of 635
/// words a second over 345.6 of a line never began.
TEST(SlowLine, HasItsRateSetOnce) {
    int by_product = 0;  // rates that the product of rate and words finds too fast again
    for (int busiest = 1; busiest < 5000; ++busiest) {
        for (const double carried : {345.6, 0.9 * 3840 / 7, 1000.0}) {
            const double rate = rate_that_link_carries(carried, busiest, 1);
            EXPECT_NEAR(rate, std::min(1.0, carried / busiest), 1e-12);
            EXPECT_EQ(rate_that_link_carries(carried, busiest, rate), rate) << busiest;
            if (busiest * rate > carried) ++by_product;
        }
    }
    EXPECT_GT(by_product, 100);
    EXPECT_EQ(rate_that_link_carries(0, 635, 0.5), 0.5);
    EXPECT_EQ(rate_that_link_carries(345.6, 0, 0.5), 0.5);
}

class LongLossyLinks : public LossyLinks {};

TEST_F(LongLossyLinks, TenBadOnesChangeNoClock) { expect_the_same_clocks(1, 10); }

/// Control: a network that is too bad is reported.
TEST_F(LongLossyLinks, WorseOneIsTold) {
    const Drawn drawn = over({1, 0.5, 0.1, 0.5, 0.2});
    EXPECT_TRUE(drawn.held);
    EXPECT_GT(drawn.waits, 0U);
    EXPECT_EQ(drawn.steps.size(), good_.steps.size());
    EXPECT_FALSE(drawn.steps == good_.steps);
}

}  // namespace
}  // namespace curvecore::sysc
