// SPDX-License-Identifier: Apache-2.0
// A bench for a core that draws curves against hls::MotionKernel: segments and requests go in,
// samples are compared bit for bit. The widths are those of the linked core.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "sysc/core/core_clocks.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/bench/bench_format.hpp"
#include "tb/support/bench/curve_ports.hpp"
#include "tb/support/bench/sample_campaign.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/segments/legal_segments.hpp"

namespace curvecore::tb {

using namespace sysc;

using Fine = std::array<int64_t, kMostAxes>;

/// The bench; Shapes makes segments by `next()` and `whole(k, steps)`; a round has 500 samples.
template <class Shapes, int Rounds>
class CurveCoreBench : public testing::Test, protected BenchFormat {
  protected:
    using Segments = std::vector<RunSegment>;
    using Campaign = SampleCampaign<Shapes>;

    CurveCoreBench() {
        dut_.limit_cycles(20'000'000);
        dut_.reset();
    }

    /// The core for hls/clocks.hpp, with its build and curves, which a module's own parameters do
    /// not tell.
    static hls::TimedCore timed(Build build, bool arcs, bool splines) {
        CoreParameters core = core_configuration().parameters;
        core.build = build;
        core.splines = splines ? 1 : 0;
        hls::TimedCore timed = timed_core(core);
        timed.arcs = arcs;
        return timed;
    }

    void add(const RunSegment& segment) {
        segments_.push_back(segment);
        const std::vector<uint64_t> words = bus_words(segment, 0);
        bus_.insert(bus_.end(), words.begin(), words.end());
    }

    /// Asks the kernel for the sample of a request; `more()` adds segments when the path needs
    /// them.
    template <class More>
    Fine predict(int64_t ds, More&& more) {
        Fine fine{};
        kernel_.sample(
            ds,
            [&] {
                while (drawn_ >= segments_.size()) more();
                path_end_ += segments_[drawn_].length;
                return segments_[drawn_++];
            },
            fine.data());
        path_ += ds;
        return fine;
    }

    /// Advances by one clock with the given handshakes; a request is taken from, and a sample
    /// compared with, the expectation.
    void clock(bool offer_segment, bool offer_request, bool take_sample) {
        drive(dut_, offer_segment, offer_request, take_sample);
        if (fresh_) {
            drive(*fresh_, offer_segment, offer_request, take_sample);
            compare_with_fresh();
            fresh_->tick();
        }
        const bool segment = dut_->segment_valid_i && dut_->segment_ready_o;
        const bool request = dut_->request_valid_i && dut_->request_ready_o;
        const bool sample = dut_->sample_valid_o && dut_->sample_ready_i;
        if (sample) compare();
        dut_.tick();
        if (segment) bus_.pop_front();
        if (request) {
            requests_.pop_front();
            last_request_ = dut_.cycle();
        }
        if (sample) last_sample_ = dut_.cycle();
    }

    void drive(CurveCore& dut, bool offer_segment, bool offer_request, bool take_sample) {
        dut->segment_valid_i = offer_segment && !bus_.empty();
        dut->segment_data_i = bus_.empty() ? 0 : bus_.front();
        dut->request_valid_i = offer_request && !requests_.empty();
        dut->request_ds_i = requests_.empty() ? 0 : requests_.front();
        dut->sample_ready_i = take_sample;
        dut.settle();
    }

    void compare_with_fresh() {
        const CurvePorts& fresh = *fresh_->operator->();
        ASSERT_EQ(dut_->segment_ready_o, fresh.segment_ready_o);
        ASSERT_EQ(dut_->request_ready_o, fresh.request_ready_o);
        ASSERT_EQ(dut_->empty_segments_o, fresh.empty_segments_o);
        ASSERT_EQ(dut_->sample_valid_o, fresh.sample_valid_o);
        for (int a = 0; a < core_.axes() && fresh.sample_valid_o; ++a) {
            ASSERT_EQ(dut_->sample_fine_o[a], fresh.sample_fine_o[a]);
        }
    }

    void compare() {
        ASSERT_FALSE(expected_.empty()) << "a sample that nobody asked for";
        for (int a = 0; a < core_.axes(); ++a) {
            const int64_t truth = expected_.front()[a];
            ASSERT_EQ(dut_->sample_fine_o[a], truth) << "sample " << compared_ << " axis " << a;
            ASSERT_EQ(dut_->sample_position_o[a], hls::to_position(truth, format_))
                << "sample " << compared_;
        }
        expected_.pop_front();
        ++compared_;
    }

    /// Clocks until every requested sample has come.
    template <class Chance>
    void drain(Chance&& chance) {
        int idle = 0;
        while (!expected_.empty()) {
            const auto before = std::make_pair(compared_, bus_.size());
            clock(chance(), chance(), chance());
            if (HasFatalFailure()) return;
            idle = std::make_pair(compared_, bus_.size()) == before ? idle + 1 : 0;
            ASSERT_LT(idle, 100'000) << "no sample comes";
        }
    }

    /// A path increment of one of the relevant kinds.
    int64_t random_ds() {
        const int k = drawn_ == 0 ? 4 : segments_[drawn_ - 1].step_exponent;
        const int64_t step = int64_t{1} << (k + hls::kPathFrac);
        const int64_t to_end = path_end_ - path_;
        const auto some = [&](int64_t limit) {
            return static_cast<int64_t>(random_() % static_cast<uint64_t>(limit + 1));
        };
        switch (random_() % 16) {
            case 0:
                return 0;
            case 1:
                return to_end;  // an exact landing
            case 2:
                return to_end + 1;
            case 3:
                return step;
            case 4:
                return some(3 * step);
            case 5:
                return some(3);
            default:
                return some(step >> (random_() % 8));
        }
    }

    /// Compares random requests over random segments, at full speed and with stalls on all three
    /// ports.
    void equals_kernel_with_random_stalls() {
        Shapes shapes(core_, 11);
        const auto more = [&] { add(shapes.next()); };
        const int rounds = portable() ? cases(std::min(4, Rounds), Rounds) : 8;
        for (int round = 0; round < rounds; ++round) {
            const int part = round % 4;  // 0: full speed
            const auto chance = [&] {
                return part == 0 || static_cast<int>(random_() % 4) >= part;
            };
            for (int n = 0; n < 500; ++n) {
                const int64_t ds = random_ds();
                requests_.push_back(ds);
                expected_.push_back(predict(ds, more));
            }
            ASSERT_NO_FATAL_FAILURE(drain(chance)) << "round " << round;
        }
        EXPECT_EQ(compared_, rounds * 500);
        EXPECT_GT(kernel_.segments(), 100);
        EXPECT_GT(kernel_.empty_segments(), 10);
        EXPECT_EQ(dut_->empty_segments_o, kernel_.empty_segments());
    }

    /// Checks for one sample per interval, over all of these segments, while steps hold the samples
    /// of `step_clocks`.
    void gives_one_sample_per_interval(const Segments& segments, int step_clocks) {
        const int step_samples = (step_clocks + core_.sample_interval - 1) / core_.sample_interval;
        int64_t count = 0;
        for (const RunSegment& segment : segments) {
            add(segment);
            const int64_t ds =
                (int64_t{1} << (segment.step_exponent + hls::kPathFrac)) / step_samples;
            for (int64_t left = segment.length; left > 0; left -= ds, ++count) {
                requests_.push_back(std::min(ds, left));
                expected_.push_back(predict(std::min(ds, left), [] { FAIL(); }));
            }
        }
        for (int n = 0; n < 8 * step_clocks; ++n) clock(true, false, true);  // steps ahead
        while (compared_ == 0) clock(true, true, true);
        const uint64_t first = dut_.cycle();
        while (!expected_.empty() && !this->HasFatalFailure()) clock(true, true, true);
        EXPECT_EQ(dut_.cycle() - first, static_cast<uint64_t>((count - 1) * core_.sample_interval));
    }

    /// Checks that samples a step apart come at the pace of the steps; a sample that waits for its
    /// step is tried every second slot.
    void takes_the_stated_clocks_a_step(const Segments& segments, int clocks) {
        for (const RunSegment& segment : segments) {
            add(segment);
            const int64_t ds = int64_t{1} << (segment.step_exponent + hls::kPathFrac);
            for (int64_t left = segment.length; left > 0; left -= ds) {
                requests_.push_back(ds);
                expected_.push_back(predict(ds, [] { FAIL(); }));
            }
        }
        const auto until = [&](std::size_t left) {
            while (expected_.size() > left && !this->HasFatalFailure()) clock(true, true, true);
            return static_cast<double>(last_sample_);
        };
        // The first samples are made ahead; the last one of a segment needs no step after it.
        const std::size_t count = expected_.size() - 9;
        const double first = until(count + 1);
        EXPECT_NEAR(until(1) - first, static_cast<double>(count) * clocks,
                    2 * core_.sample_interval);
        until(0);
        start_afresh();
    }

    /// Checks for a number of clocks from request to sample in [low, low + SampleInterval), in the
    /// first of two steps.
    void has_latency(int low, int step_clocks) {
        for (int n = 0; n < 8 * step_clocks; ++n) clock(true, false, true);
        for (int n = 0; n < 20; ++n) {
            requests_.push_back(10);
            expected_.push_back(predict(10, [] { FAIL(); }));
            while (!expected_.empty()) clock(true, true, true);
            const auto latency = static_cast<int>(last_sample_ - last_request_);
            EXPECT_GE(latency, low);
            EXPECT_LT(latency, low + core_.sample_interval);
        }
    }

    /// Checks that nothing is lost while no samples are taken.
    void holds_its_sample_while_stalled() {
        Shapes shapes(core_, 5);
        add(shapes.whole(6, 2));
        for (int n = 0; n < 400; ++n) {
            requests_.push_back(10 * n);
            expected_.push_back(predict(10 * n, [] { FAIL(); }));
        }
        for (int n = 0; n < 4000; ++n) clock(true, true, false);
        EXPECT_EQ(dut_->sample_valid_o, 1);
        EXPECT_FALSE(requests_.empty());
        drain([] { return true; });
    }

    /// Checks that clocks are at most `bound`, and within `close` of it.
    static void reaches(uint64_t clocks, uint64_t bound, uint64_t close) {
        EXPECT_LE(clocks, bound);
        EXPECT_GE(clocks + close, bound);
    }

    static constexpr uint64_t kSamples = 60;

    /// Clocks for `count` samples of a step after its first.
    uint64_t clocks_within_a_step(const RunSegment& segment, uint64_t count) {
        add(segment);
        for (uint64_t n = 0; n <= count; ++n) {
            requests_.push_back(10);
            expected_.push_back(predict(10, [] { FAIL(); }));
        }
        while (expected_.size() > count) clock(true, true, true);
        const uint64_t first = last_sample_;
        while (!expected_.empty()) clock(true, true, true);
        const uint64_t clocks = last_sample_ - first;
        start_afresh();
        return clocks;
    }

    /// Longest pauses from the last sample before a change to the first one after it.
    struct Pauses {
        uint64_t step = 0;
        uint64_t segment = 0;
    };

    /// Measures the pauses in segments of two steps of one length, of 2^samples_log2 samples each.
    void measure(const Segments& segments, int samples_log2, Pauses& pauses) {
        for (const auto& segment : segments) add(segment);
        const int64_t per_step = 1 << samples_log2;
        const int64_t ds = int64_t{1} << (segments.front().step_exponent + 16 - samples_log2);
        const auto count = static_cast<int64_t>(segments.size()) * 2 * per_step;
        for (int64_t n = 0; n < count; ++n) {
            requests_.push_back(ds);
            expected_.push_back(predict(ds, [] { FAIL(); }));
        }
        // A sample at the end of a step is the next step's first; at a segment's end it is the
        // step's last.
        uint64_t before = 0;
        for (int64_t n = 1; n <= count; ++n) {
            const size_t left = expected_.size();
            while (expected_.size() == left) clock(true, true, true);
            const uint64_t gap = last_sample_ - before;
            before = last_sample_;
            if (n > 1 && n % (2 * per_step) == 1) {
                pauses.segment = std::max(pauses.segment, gap);
            } else if (n % (2 * per_step) == per_step) {
                pauses.step = std::max(pauses.step, gap);
            }
        }
        start_afresh();
    }

    /// Resets the core, and forgets all requests.
    void start_afresh() {
        dut_.reset(1);
        kernel_ = RunTimeKernel(format_);
        segments_.clear();
        bus_.clear();
        requests_.clear();
        expected_.clear();
        drawn_ = 0;
        path_ = 0;
        path_end_ = 0;
    }

    /// Checks that one clock of reset makes a fresh core, at any time and with random registers:
    /// every output in every clock.
    void starts_afresh_after_a_reset() {
        Shapes shapes(core_, 3);
        const auto run = [&](uint64_t clocks) {
            for (; clocks > 0 && !this->HasFatalFailure(); --clocks) {
                if (requests_.empty()) {
                    requests_.push_back(random_ds());
                    expected_.push_back(predict(requests_.back(), [&] { add(shapes.next()); }));
                }
                clock(random_() % 4 != 0, random_() % 4 != 0, random_() % 4 != 0);
            }
        };
        for (int round = 0; round < 40; ++round) {
            run(random_() % 1000);
            fresh_ = std::make_unique<CurveCore>(round + 2);
            (*fresh_)->rst_ni = 1;
            drive(*fresh_, true, true, true);
            fresh_->tick(random_() % 100);
            start_afresh();
            drive(*fresh_, true, true, true);
            fresh_->reset(1);
            run(2000);
            fresh_.reset();
        }
        EXPECT_GT(compared_, 120);
    }

    CurveCore dut_;
    std::unique_ptr<CurveCore> fresh_;  // has the same inputs, must have the same outputs
    RunTimeKernel kernel_{format_};
    std::mt19937_64 random_{7};
    Segments segments_;
    size_t drawn_ = 0;      // segments that the kernel has taken
    int64_t path_ = 0;      // path of the requests
    int64_t path_end_ = 0;  // end of the present segment
    std::deque<uint64_t> bus_;
    std::deque<int64_t> requests_;
    std::deque<Fine> expected_;
    int64_t compared_ = 0;
    uint64_t last_request_ = 0;
    uint64_t last_sample_ = 0;
};

}  // namespace curvecore::tb
