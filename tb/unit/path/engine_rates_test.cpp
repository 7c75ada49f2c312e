// SPDX-License-Identifier: Apache-2.0
// rtl/engine/engine_rates.sv: rates leave as they came, sample by sample; what is dropped, what
// stays; references as the programs read them, axis by axis.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <random>

#include "Vengine_rates.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kAxisRate = 19;
constexpr int kUnmoved = 20;  // .. moved on, stands at, refused, refused move
constexpr int kSampleWhole = 25;
constexpr int kRateBits = 16 + CFG_PeriodLog2;

using Sample = std::array<uint64_t, CFG_Axes>;

class EngineRates : public testing::Test {
  protected:
    EngineRates() {
        dut_->out_i = 0;
        dut_->work_i = 0;
        dut_->high_i = dut_->data_i = dut_->scale_last_i = 0;
        dut_->reference_i = dut_->empty_i = dut_->taken_i = 0;
        dut_->read_axis_i = dut_->read_last_i = 0;
        dut_.reset();
        dut_->work_i = 1;
    }

    void clock() {
        dut_.tick();
        dut_->out_i = 0;
        dut_->taken_i = dut_->empty_i = dut_->reference_i = 0;
        dut_->read_last_i = dut_->scale_last_i = 0;
    }
    void put(int port, unsigned data = 0, bool high = false) {
        dut_->out_i = 1U << port;
        dut_->data_i = static_cast<uint16_t>(data);
        dut_->high_i = high ? 1 : 0;
        clock();
    }

    /// Writes a random sample as the programs do; `whole`: to its end.
    Sample write(bool whole = true) {
        Sample sample{};
        for (int axis = 0; axis < CFG_Axes; ++axis) {
            const auto kind = static_cast<int>(random_() % 5);
            const auto rate = static_cast<uint32_t>(random_());
            EXPECT_EQ(dut_->axis_o, axis);
            put(kUnmoved + kind);
            put(kAxisRate, rate & 0x7fff);
            put(kAxisRate, rate >> 15 & 0x7fff, true);
            static constexpr std::array<uint64_t, 5> kFlags{0, 1, 2, 4, 5};
            sample[static_cast<std::size_t>(axis)] = kFlags[static_cast<std::size_t>(kind)]
                                                         << kRateBits |
                                                     (rate & ((uint64_t{1} << kRateBits) - 1));
        }
        if (whole) put(kSampleWhole);
        return sample;
    }
    void take() {
        EXPECT_EQ(dut_->made_o, 1);
        EXPECT_EQ(dut_->ready_o, 1);
        dut_->taken_i = 1;
        clock();
        EXPECT_EQ(dut_->valid_o, 1);
        EXPECT_EQ(dut_->ready_o, 0);
    }
    /// Reads the sample that was taken, an axis a clock, its rate two clocks later.
    Sample read() {
        Sample sample{};
        for (int n = 0; n < CFG_Axes + 2; ++n) {
            dut_->read_axis_i = n < CFG_Axes ? static_cast<unsigned>(n) : 0;
            dut_->read_last_i = n == CFG_Axes - 1 ? 1 : 0;
            if (n > 1) sample[static_cast<std::size_t>(n - 2)] = dut_->rate_o;
            clock();
        }
        EXPECT_EQ(dut_->valid_o, 0);
        return sample;
    }

    ClockedDut<Vengine_rates> dut_;
    std::mt19937 random_{1};
};

TEST_F(EngineRates, SamplesLeaveAsTheyCame) {
    std::deque<Sample> made;
    int most = 0;
    bool taken = false;
    Sample at_hand{};
    for (int n = 0; n < 20'000 && !HasFailure(); ++n) {
        if (random_() % 2 == 0 && made.size() < 15) made.push_back(write());
        most = std::max(most, static_cast<int>(made.size()));
        ASSERT_EQ(dut_->made_o, made.empty() ? 0 : 1);
        if (!taken && !made.empty() && random_() % 2 == 0) {
            take();
            at_hand = made.front();
            made.pop_front();
            taken = true;
        }
        if (taken && random_() % 2 == 0) {
            ASSERT_EQ(read(), at_hand);
            taken = false;
        }
        if (random_() % 50 == 0) {  // those that are not taken are gone, even half a one
            if (made.size() < 15) write(false);
            dut_->work_i = 0;
            dut_->empty_i = 1;
            clock();
            dut_->work_i = 1;
            made.clear();
        }
    }
    EXPECT_EQ(most, 15);
}

TEST_F(EngineRates, AxesFollowEachOtherByTheirScales) {
    for (int n = 0; n < 2 * CFG_Axes; ++n) {
        EXPECT_EQ(dut_->axis_o, n % CFG_Axes);
        clock();
        dut_->scale_last_i = 1;
        clock();
    }
    EXPECT_EQ(dut_->axis_o, 0);
}

TEST_F(EngineRates, ReferencesStayUntilASampleIsTaken) {
    dut_->reference_i = 1;
    clock();
    dut_->reference_i = 2;
    clock();
    write();
    dut_->empty_i = 1;
    clock();
    EXPECT_EQ(dut_->references_o, 3);
    write();
    take();
    EXPECT_EQ(dut_->references_o, 0);
}

}  // namespace
}  // namespace curvecore::tb
