// SPDX-License-Identifier: Apache-2.0
// Outputs of rtl/motion_system.sv: the pins change where the program says, at any rate, through
// holds, and are off without the drives. With a shaper it is the tool that is there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "hls/path_outputs.hpp"
#include "tb/support/bench/motion_system_bench.hpp"
#include "tb/support/pins/sprung_tool.hpp"

namespace curvecore::tb {
namespace {

/// An edge of an output, and X where it is asked for, to `off` mm.
struct Edge {
    int output;
    bool on;
    double x;
    double off;
};
/// An edge of a pin: X in its clock, and a sample period later.
struct DrawnEdge {
    int output;
    bool on;
    int64_t clock;
    double x;
    double end;
};
// As tb/data/outputs.ngc says; a corner may be rounded within the tolerance of G64.
const std::vector<Edge> kEdges{{4, true, 1, 0},    {4, false, 2, 0},  {4, true, 2.1, 0},
                               {4, false, 2.2, 0}, {5, true, 2.2, 0}, {5, false, 7, 0},
                               {6, true, 7.5, 0},  {7, true, 7.5, 0}, {6, false, 10, 0.01},
                               {7, false, 6, 0},   {4, true, 2, 0},   {4, false, 2, 0}};

Part part_of(double percent) {
    return Part("outputs.ngc", ref::Holds::kBranches, [percent](sysc::Options& options) {
        options.outputs = CFG_Outputs;
        options.segment_queue_words = CFG_SegmentQueueWords;
        options.profile_queue_words = CFG_ProfileQueueWords;
        options.rules.laser = true;
        options.override_percent = percent;
    });
}

class MotionOutputs : public MotionSystem {
  protected:
    void SetUp() override {
        host_.each_clock = [this] { watch(); };
        if (CFG_Shaper == 0) return;
        constexpr double kSample = static_cast<double>(kSystemPeriod) / CFG_ClockHertz;  // s
        shape(host_, ref::ShaperKind::kFeedForward, kSample, kSystemAxes, CFG_Shaper);
    }

    void watch() {
        if (!host_->enable_o) {
            ASSERT_EQ(host_->output_o, 0);
            ASSERT_EQ(host_->pwm_o, 0);
        }
        double x = static_cast<double>(host_.drive(0).count() - start_[0]) / kStepsPerMm;
        if (CFG_Shaper != 0) {
            tool_.follow(x, 1.0 / CFG_ClockHertz);
            x = tool_.place();
        }
        for (auto edge = edges_.rbegin(); edge != edges_.rend(); ++edge) {
            if (host_.now() > edge->clock + kSystemPeriod) break;
            edge->end = x;
        }
        for (int n = 4; n < 8; ++n) {
            const bool on = host_->output_o >> n & 1;
            if (on == bool(last_ >> n & 1) || !host_->enable_o) continue;
            edges_.push_back({n, on, host_.now(), x, x});
        }
        last_ = host_->output_o;
    }

    /// Draws the part; `between` is called from its begin on.
    void draw(const std::function<void()>& between) {
        RegisterHost::Sent sent;
        while (host_.path() != part_.job.plan.path_length() && !HasFailure()) {
            host_.feed(part_, sent, [] {});
            if (host_.path() > 0) between();
            host_.samples(2);
        }
        host_.finish(part_);
        host_.samples(CFG_Shaper);
        expect_drawn(start_);
    }

    /// Checks that all edges came, each at the begin of the sample in which its place is.
    void expect_edges() {
        // A pin steps half-way; a tool is a little off the path.
        const double rounding = (CFG_Shaper == 0 ? 0.6 : 1.2) / kStepsPerMm;
        ASSERT_EQ(edges_.size(), kEdges.size());
        for (std::size_t n = 0; n < kEdges.size(); ++n) {
            const auto [from, to] = std::minmax(edges_[n].x, edges_[n].end);
            EXPECT_EQ(edges_[n].output, kEdges[n].output) << n;
            EXPECT_EQ(edges_[n].on, kEdges[n].on) << n;
            EXPECT_GE(kEdges[n].x, from - rounding - kEdges[n].off) << n;
            EXPECT_LE(kEdges[n].x, to + rounding + kEdges[n].off) << n;
        }
    }
    uint32_t power() { return CURVECORE_FIELD(host_.read(CURVECORE_OUTPUTS), OUTPUTS_POWER); }

    std::vector<DrawnEdge> edges_;
    SprungTool tool_;
    unsigned last_ = 0;
    std::vector<int64_t> start_{0, 0, 0};  // steps, where the program begins
};

class MotionOutputsAtRates : public MotionOutputs, public testing::WithParamInterface<int> {};

TEST_P(MotionOutputsAtRates, ChangeWhereTheProgramSays) {
    part_ = part_of(GetParam());
    host_.prepare(part_);
    uint32_t most = 0;
    draw([&] { most = std::max(most, power()); });
    expect_edges();
    // M4: the whole level at the feed, in proportion below it.
    const double rate = std::min(GetParam() / 100.0, 1.0);
    EXPECT_NEAR(most, rate * hls::kMostLevel, 0.01 * hls::kMostLevel);
    EXPECT_EQ(host_.read(CURVECORE_OUTPUTS) >> CURVECORE_OUTPUTS_BITS_LOW & 0xf, 0U);
    EXPECT_EQ(power(), 0U);
}

std::vector<int> percents() {
    if (std::getenv("CURVECORE_LONG") != nullptr) return {1, 50, 99, 100, 150};
    return {50, 99, 150};
}

INSTANTIATE_TEST_SUITE_P(Percent, MotionOutputsAtRates, testing::ValuesIn(percents()),
                         [](const auto& form) {
                             return "At" + std::to_string(form.param) + "Percent";
                         });

TEST_F(MotionOutputs, KeepTheirPlacesThroughHolds) {
    part_ = part_of(100);
    host_.prepare(part_);
    int holds = 0;
    draw([&] {
        host_.tenths(1500);
        host_.write(CURVECORE_CONTROL, kEnable | kHold);
        for (int n = 0; n < 4000 && !host_.is(CURVECORE_STATE_STANDING_MASK); ++n) host_.samples(1);
        host_.samples(CFG_SamplesAhead + 2);
        EXPECT_EQ(power(), 0U) << "a laser at rest";
        holds += host_.path() < part_.job.plan.path_length();
        host_.write(CURVECORE_CONTROL, kEnable);
        host_.samples(2);
    });
    expect_edges();
    EXPECT_GT(holds, 2);
}

TEST_F(MotionOutputs, AreOffBehindAnEmergencyStopAndThenDrawAgain) {
    part_ = part_of(100);
    for (int n = 0; n < 4; ++n) {
        host_.prepare(part_);
        RegisterHost::Sent sent;
        while (edges_.empty() && !HasFailure()) host_.feed(part_, sent, [] {});
        host_.clocks(static_cast<int64_t>(random_() % 5000));
        EXPECT_NE(host_->output_o, 0);
        host_->estop_i = 1;
        host_.clocks(3);
        EXPECT_EQ(host_->output_o, 0);
        EXPECT_EQ(host_->pwm_o, 0);
        host_->estop_i = 0;
        host_.clocks(100);
        clear_faults();
        host_.write(CURVECORE_CONTROL, kEnable);
        host_.tenths(100);
        EXPECT_EQ(host_->output_o, 0) << "until a program asks for them";
        host_.write(CURVECORE_CONTROL, 0);
        host_.tenths(100);
        edges_.clear();
    }
    clear_faults();
    host_.prepare(part_);
    start_ = counts();
    draw([] {});
    expect_edges();
}

TEST_F(MotionOutputs, CutTheStreamWhereOneIsMissing) {
    part_ = part_of(100);
    const auto is_output = [](uint64_t word) {
        return hls::get(hls::kTagField, word) == static_cast<uint64_t>(hls::Tag::kOutput);
    };
    part_.pieces.erase(std::find_if(part_.pieces.begin(), part_.pieces.end(), is_output));
    host_.prepare(part_);
    for (std::size_t n = 0; !host_.is(kMotionFaults) && n < part_.pieces.size(); ++n) {
        host_.push(CURVECORE_PROFILE_LO, part_.pieces[n]);
        host_.clocks(200);
    }
    EXPECT_TRUE(host_.is(4U << CURVECORE_STATE_MOTION_LOW)) << "piece_word";
}

}  // namespace
}  // namespace curvecore::tb
