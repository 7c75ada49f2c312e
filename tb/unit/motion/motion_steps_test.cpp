// SPDX-License-Identifier: Apache-2.0
// A program from its words to step pulses: rtl/motion_interpolator.sv and
// rtl/pulse/step_generator.sv on one clock, fed by the host.
#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <memory>
#include <vector>

#include "Vmotion_interpolator.h"
#include "sysc/board/feeder.hpp"
#include "sysc/words/path_source.hpp"
#include "tb/support/pins/step_bench.hpp"
#include "tb/support/pins/watched_axis.hpp"

namespace curvecore::tb {
namespace {

constexpr int64_t kStepsPerMm = 400;
constexpr int64_t kAhead = 16;  // samples requested before they are due: the core pauses at steps

/// Core and step generator; the sample timer is the step generator's.
class StepMachine : public Board {
  public:
    StepMachine(const BoardSettings& settings, int64_t scale, const hls::PulseTimes& times) {
        core_.limit_cycles(UINT64_MAX);
        core_->segment_valid_i = 0;
        core_->profile_valid_i = 0;
        core_->sample_request_valid_i = 0;
        core_->sample_ready_i = 0;
        core_->hold_i = 0;
        core_->kill_i = 0;
        core_->override_i = to_port(settings.override_word, 17);
        core_->samples_per_tick_log2_i = to_port(settings.samples_per_tick_log2, 4);
        core_->hold_acceleration_i = settings.hold_acceleration;
        core_->hold_slope_i = settings.hold_slope;
        core_->digest_i = settings.digest;
        core_->stop_ticks_i = settings.stop_ticks;
        core_.reset();
        core_.tick();
        steps_.set_times(times);
        for (int a = 0; a < kStepAxes; ++a) {
            steps_.set_scale(a, scale);
            axes_.emplace_back(scale, kFineBits, kPeriod, times);
        }
        steps_.reference();
    }

    std::size_t write(Stream stream, const uint64_t* words, std::size_t count) override {
        std::deque<uint64_t>& inlet = inlets_[stream == Stream::kProfile];
        if (!inlet.empty() || count == 0) return 0;
        inlet.push_back(*words);
        return 1;
    }
    bool arrived(Stream stream) const override {
        return inlets_[stream == Stream::kProfile].empty();
    }
    bool full(Stream stream) const override {
        return refused_[stream == Stream::kProfile] > kCounts;
    }
    bool paced() const override { return true; }
    void request(uint64_t samples) override { requested_ += samples; }

    /// Advances by one clock.
    void work(std::vector<Sample>& samples) override {
        core_->segment_valid_i = !inlets_[0].empty();
        core_->profile_valid_i = !inlets_[1].empty();
        if (!inlets_[0].empty()) core_->segment_data_i = inlets_[0].front();
        if (!inlets_[1].empty()) core_->profile_data_i = inlets_[1].front();
        core_->sample_request_valid_i = requested_ > 0 && under_way_ < kAhead;
        core_.settle();
        steps_->sample_valid_i = core_->sample_valid_o;
        for (int n = 0; n < 4; ++n) steps_->sample_i[n] = core_->sample_fine_o[n];
        steps_->eval();
        core_->sample_ready_i = steps_->sample_ready_o;
        core_.settle();
        const bool asked = core_->sample_request_valid_i && core_->sample_request_ready_o;
        const bool takes[] = {core_->segment_ready_o != 0, core_->profile_ready_o != 0};
        for (int n = 0; n < 2; ++n) {
            refused_[n] = !inlets_[n].empty() && !takes[n] ? refused_[n] + 1 : 0;
            if (!inlets_[n].empty() && takes[n]) inlets_[n].pop_front();
        }
        if (asked) --requested_;
        under_way_ += asked ? 1 : 0;
        Sample sample;
        for (int a = 0; a < kStepAxes; ++a) {
            sample.fine[a] = signed_field(core_->sample_fine_o, a * kFineBits, kFineBits);
        }
        const int64_t ticked = steps_.ticked();
        const bool taken = steps_.clock();
        core_.tick();
        if (steps_.ticked() != ticked) begin_period();
        for (int a = 0; a < kStepAxes; ++a) {
            axes_[a].watch(steps_.now(), steps_.step(a), steps_.direction(a));
        }
        if (!taken) return;
        --under_way_;
        next_ = sample;
        waits_ = true;
        samples.push_back(sample);
    }

    BoardStatus status() const override {
        return {static_cast<uint64_t>(steps_.now()), core_->underrun_o != 0, core_->fault_o, 0, 0};
    }

    /// Rests for some periods at the last sample.
    void rest() {
        std::vector<Sample> samples;
        request(8);
        while (samples.size() < 8 && !testing::Test::HasFatalFailure()) work(samples);
        for (int64_t n = 0; n < 2 * kPeriod; ++n) work(samples);
    }

    const WatchedAxis& axis(int a) const { return axes_[a]; }
    Vstep_generator& steps() { return *steps_.operator->(); }
    int late() const { return steps_.late(); }

  private:
    void begin_period() {
        if (!waits_) return;
        waits_ = false;
        for (int a = 0; a < kStepAxes; ++a) {
            if (stands_) axes_[a].moves_to(next_.fine[a], steps_.ticked() + kLatency + a);
            if (!stands_) axes_[a].stands_at(next_.fine[a]);
        }
        stands_ = true;
    }

    ClockedDut<Vmotion_interpolator> core_;
    StepBench steps_;
    std::vector<WatchedAxis> axes_;
    std::deque<uint64_t> inlets_[2];
    static constexpr int kCounts = 4;  // clocks: an entry that counts a frame takes no word
    int refused_[2] = {0, 0};
    uint64_t requested_ = 0;
    int64_t under_way_ = 0;
    bool waits_ = false;   // a sample was taken, its tick follows
    bool stands_ = false;  // the first sample came
    Sample next_;
};

/// Draws the part; returns the steps that all drives saw.
int64_t draw(const std::string& file) {
    Options options;
    options.file = std::string(DATA_DIR) + "/" + file;
    options.core.build = Build::kParallel;
    options.core.splines = 1;
    options.core.mode = 1;
    options.splines_set = true;
    options.clock_hz = static_cast<double>(kPeriod) / options.sample_period_s;
    const Job job = plan_job(options);
    // Scale of 400 steps per mm, for 2^42 units of 2^-10 nm.
    const auto scale = std::llround(static_cast<double>(kStepsPerMm) * options.unit_mm *
                                    std::exp2(kFineBits + hls::kStepFraction - 10));
    StepMachine machine(board_settings(job), scale, {2, 2, 4, 4});
    Feeder feeder(job, count_samples(job.plan, 0, options.override_word()), machine);
    std::vector<Sample> samples;
    while (!feeder.done() && !testing::Test::HasFatalFailure()) {
        samples.clear();
        feeder.turn(samples);
    }
    machine.rest();
    EXPECT_EQ(machine.status().fault, 0U);
    EXPECT_FALSE(machine.status().underrun);
    EXPECT_EQ(machine.late(), 0);
    EXPECT_EQ(machine.steps().overrun_o | machine.steps().refused_o, 0);
    int64_t steps = 0;
    const ref::Move& last = job.plan.moves.back();
    for (int a = 0; a < kStepAxes; ++a) {
        const WatchedAxis& axis = machine.axis(a);
        EXPECT_TRUE(axis.idle()) << "axis " << a << ": steps are lost";
        EXPECT_EQ(axis.monitor().count(), std::llround(last.end[a] * kStepsPerMm)) << "axis " << a;
        steps += axis.monitor().steps();
    }
    printf("%s: %ld steps\n", file.c_str(), steps);
    return steps;
}

/// The part; CURVECORE_PART: another file of tb/data (scripts/campaign.sh: the demo).
TEST(MotionSteps, CountWhatTheProgramSays) {
    const char* part = std::getenv("CURVECORE_PART");
    EXPECT_GT(draw(part != nullptr ? part : "pulses.ngc"), 1000);
}

}  // namespace
}  // namespace curvecore::tb
