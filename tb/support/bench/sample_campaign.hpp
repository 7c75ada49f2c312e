// SPDX-License-Identifier: Apache-2.0
// A campaign of samples of a core against its kernel: every fine word and position of random chains
// of segments, mostly at a working density, with random stalls and holds. CURVECORE_SAMPLES sets
// their number (scripts/campaign.sh: 10^9 over all configurations).
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>
#include <vector>

#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/bench/bench_format.hpp"
#include "tb/support/bench/curve_ports.hpp"

namespace curvecore::tb {
using namespace sysc;

/// Returns false for models of DSP primitives, which simulate slowly.
inline bool portable() { return core_configuration().parameters.multiplier_form == 0; }

/// The campaign; Shapes makes the segments.
template <class Shapes>
class SampleCampaign : BenchFormat {
  public:
    /// Creates it. `samples` without CURVECORE_SAMPLES: a few seconds' worth, fewer for slow
    /// models. A step has at least 2^density samples, except for held requests.
    SampleCampaign(int samples, int density)
        : samples_(portable() ? samples : samples / 50), least_density_(density) {
        const char* wanted = std::getenv("CURVECORE_SAMPLES");
        if (wanted != nullptr) samples_ = std::atoll(wanted);
        dut_.reset();
        dut_.limit_cycles(~std::uint64_t{0});
    }

    void run() {
        make_chain();
        const auto wanted = static_cast<std::size_t>(samples_);
        std::size_t waiting = 0;
        std::size_t before = 0;
        bool stalling = false;
        while (compared_ < wanted) {
            if (compared_ % 4096 == 0) stalling = random_() % 4 == 0;
            clock(stalling ? static_cast<unsigned>(random_() & random_()) : 0);
            waiting = compared_ == before ? waiting + 1 : 0;
            before = compared_;
            ASSERT_LT(waiting, 100'000U) << "no sample comes after " << compared_;
            ASSERT_EQ(differing_, 0) << "at sample " << compared_;
        }
        testing::Test::RecordProperty("samples", std::to_string(compared_));
        testing::Test::RecordProperty("segments", std::to_string(drawn_));
        std::printf("%zu samples of %zu segments in %llu clocks, %lld words differ\n", compared_,
                    drawn_, static_cast<unsigned long long>(dut_.cycle()),
                    static_cast<long long>(differing_));
    }

  private:
    static constexpr std::size_t kRing = 1024;  // more than the core holds in flight

    /// Segment n of the chain, which repeats; the core and the kernel read it each at its own pace.
    const RunSegment& segment(std::size_t n) const { return chain_[n % chain_.size()]; }

    std::int64_t next_ds() {
        if (--density_left_ < 0) {
            density_left_ = static_cast<std::int64_t>(random_() % 2000);
            hold_ = random_() % 16 == 0;
            density_ = least_density_ + static_cast<int>(random_() % 4);
        }
        const int step = segment(drawn_ == 0 ? 0 : drawn_ - 1).step_exponent + hls::kPathFrac;
        const std::int64_t ds = step > density_ ? std::int64_t{1} << (step - density_) : 1;
        return hold_ && density_left_ < 50 ? 0 : ds + static_cast<std::int64_t>(random_() & 1);
    }

    void predict(std::int64_t ds) {
        kernel_.sample(
            ds, [&]() -> const RunSegment& { return segment(drawn_++); },
            expected_[asked_ % kRing].data());
    }

    void compare() {
        const auto& truth = expected_[compared_ % kRing];
        for (int a = 0; a < core_.axes(); ++a) {
            const std::int64_t word = truth[static_cast<std::size_t>(a)];
            differing_ += dut_->sample_fine_o[a] != word;
            differing_ += dut_->sample_position_o[a] != hls::to_position(word, format_);
        }
        ++compared_;
    }

    /// Advances by one clock; each handshake is offered unless the random bits stall it.
    void clock(unsigned stalls) {
        dut_->segment_valid_i = (stalls & 1) == 0;
        dut_->segment_data_i = bus_[bus_place_];
        if (!requesting_) {
            ds_ = next_ds();
            predict(ds_);
            requesting_ = true;
            ++asked_;
        }
        dut_->request_valid_i = (stalls & 2) == 0 && asked_ - compared_ < kRing;
        dut_->request_ds_i = static_cast<std::uint64_t>(ds_);
        dut_->sample_ready_i = (stalls & 4) == 0;
        dut_.settle();
        const bool word_taken = dut_->segment_valid_i && dut_->segment_ready_o;
        const bool request_taken = dut_->request_valid_i && dut_->request_ready_o;
        if (dut_->sample_valid_o && dut_->sample_ready_i) compare();
        dut_.tick();
        if (request_taken) requesting_ = false;
        if (word_taken && ++bus_place_ == bus_.size()) bus_place_ = 0;
    }

    void make_chain() {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Shapes shapes(core_, seed);
            for (int n = 0; n < 500; ++n) chain_.push_back(shapes.next());
        }
        for (std::size_t n = 0; n < chain_.size(); ++n) {
            const std::vector<uint64_t> words = bus_words(chain_[n], static_cast<unsigned>(n));
            bus_.insert(bus_.end(), words.begin(), words.end());
        }
    }

    std::int64_t samples_;
    int least_density_;
    CurveCore dut_;
    RunTimeKernel kernel_{format_};
    std::mt19937_64 random_{3};
    std::vector<RunSegment> chain_;
    std::vector<std::uint64_t> bus_;
    std::size_t bus_place_ = 0;
    std::size_t drawn_ = 0;
    std::array<std::array<std::int64_t, kMostAxes>, kRing> expected_{};
    std::size_t asked_ = 0;
    std::size_t compared_ = 0;
    std::int64_t differing_ = 0;
    std::int64_t ds_ = 0;
    bool requesting_ = false;
    std::int64_t density_left_ = 0;
    int density_ = 0;
    bool hold_ = false;
};

}  // namespace curvecore::tb
