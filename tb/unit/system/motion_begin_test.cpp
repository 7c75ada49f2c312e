// SPDX-License-Identifier: Apache-2.0
// Begin of a program on rtl/motion_system.sv: its rate and its place.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tb/support/bench/motion_system_bench.hpp"

namespace curvecore::tb {
namespace {

using MotionBegin = MotionSystem;

/// Moves each of the part's points by `steps`.
void move(Part& part, const std::vector<double>& steps) {
    hls::WordCheck check(part.settings.digest);
    constexpr std::size_t kFrame = ref::segment_bus_words(0);
    for (std::size_t n = 0; n < part.segments.size(); ++n) {
        const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, part.segments[n]));
        if (tag == hls::Tag::kStart || tag == hls::Tag::kEnd) {
            const double units =
                steps[(n % kFrame - 2) / 5] / kStepsPerMm / part.job.options.unit_mm;
            const int64_t point = hls::detail::signed_bits(part.segments[n], 44) +
                                  std::llround(std::ldexp(units, kFineBits - 32));
            part.segments[n] = hls::detail::bus_word(tag, hls::kPointField, point);
        }
        if (n % kFrame == kFrame - 1) check.seal(&part.segments[n + 1 - kFrame], kFrame);
    }
}

/// Steps since the last reference.
std::vector<double> way(const std::vector<int64_t>& from, const std::vector<int64_t>& to) {
    std::vector<double> steps;
    for (std::size_t a = 0; a < to.size(); ++a) steps.push_back(double(to[a] - from[a]));
    return steps;
}

TEST_F(MotionBegin, BeginsAtAnOverrideThatIsWrittenAtRest) {
    host_.prepare(part_);
    host_.samples(50);  // samples are requested, at the full rate
    const uint32_t slow = 655;
    host_.write(CURVECORE_OVERRIDE, slow);
    host_.samples(20);
    RegisterHost::Sent sent;
    const auto check = [&] {
        const bool begun = host_.path() != 0;
        ASSERT_TRUE(!begun || host_.read(CURVECORE_RATE) == slow);
    };
    for (int begun = 0; begun < 20 && !sent.all(part_) && !HasFailure();) {
        host_.feed(part_, sent, check);
        begun += host_.path() != 0 ? 1 : 0;
    }
    EXPECT_GT(host_.path(), 0U);
    EXPECT_TRUE(host_.is(CURVECORE_STATE_ACTIVE_MASK));
}

TEST_F(MotionBegin, BeginsAProgramWhereTheAxesStandAndNowhereElse) {
    host_.prepare(part_);
    std::vector<int64_t> reference = counts();
    host_.draw(part_);
    for (const double off : {0.4, 25.0, -1.1}) {
        const auto stands = counts();
        std::vector<double> start = way(reference, stands);
        start[random_() % kSystemAxes] += off;
        host_.write(CURVECORE_CONTROL, kEnable | kFlush);
        while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
        Part part = part_to_draw();
        move(part, start);
        RegisterHost::Sent sent;  // a segment gives the place
        for (; sent.segments < ref::segment_bus_words(0); ++sent.segments) {
            ASSERT_TRUE(host_.push(CURVECORE_SEGMENT_LO, part.segments[sent.segments]));
        }
        if (std::abs(off) < 0.5) {
            host_.draw_rest(part, sent, [] {});
            expect_drawn(stands);
        } else {
            host_.samples(40);
            EXPECT_EQ(host_.state() & (kFaults | CURVECORE_STATE_ENABLED_MASK),
                      uint32_t{CURVECORE_STATE_REFUSED_MASK});
            EXPECT_EQ(counts(), stands);
            clear_faults();
            host_.prepare(part_);
            reference = counts();
            host_.draw(part_);
            expect_drawn(stands);
        }
        if (HasFailure()) FAIL() << off << " steps";
    }
}

/// The steps that were made give the place: the path's place is less than a step from it.
TEST_F(MotionBegin, BeginsAProgramWhereAFlushInMotionStopped) {
    for (int repeat = 0; repeat < 2 && !HasFailure(); ++repeat) {
        const std::vector<int64_t> reference = counts();
        begin(300 + random_() % 700);
        host_.write(CURVECORE_CONTROL, kEnable | kFlush);
        while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
        const auto stands = counts();
        Part part = part_to_draw();
        move(part, way(reference, stands));
        host_.draw(part);
        expect_drawn(stands);
        host_.write(CURVECORE_CONTROL, 0);
        while (host_.is(CURVECORE_STATE_FLUSHING_MASK)) host_.samples(1);
    }
}

/// A board, or a host, other than those that draw.
struct Other {
    const char* what;
    std::function<void(sysc::Options&)> change;
};

const std::vector<Other> kOthers{
    {"order", [](sysc::Options& o) { o.core.order = 5; }},
    {"mode",  // with an order for which its clocks suffice
     [](sysc::Options& o) {
         o.core.mode = 0;
         o.core.order = 4;
     }},
    {"coefficients", [](sysc::Options& o) { o.core.coef_bits = 34; }},
    {"positions", [](sysc::Options& o) { o.core.position_bits = 30; }},
    {"guard", [](sysc::Options& o) { o.core.guard_bits = 6; }},
    {"build",
     [](sysc::Options& o) {
         const bool serial = o.core.build == sysc::Build::kSerial;
         o.core.build = serial ? sysc::Build::kParallel : sysc::Build::kSerial;
     }},
    {"splines",
     [](sysc::Options& o) {
         o.core.splines = 0;
         o.file = DATA_DIR "/lines.ngc";
         o.exact_path = true;
     }},
    {"period",
     [](sysc::Options& o) {
         o.sample_period_s *= 2;
         o.clock_hz /= 2;
     }},
    {"clocks of a period", [](sysc::Options& o) { o.sample_period_s *= 2; }},
    {"clock", [](sysc::Options& o) { o.clock_hz *= 2; }},
    {"unit", [](sysc::Options& o) { o.unit_mm = 2e-6; }},
    {"samples per tick", [](sysc::Options& o) { o.samples_per_tick = 2; }},
    {"machine", [](sysc::Options& o) { o.machine = DATA_DIR "/example_machine.ini"; }},
};

TEST_F(MotionBegin, LetsNoWordsInThatAreMadeForAnotherConfiguration) {
    std::vector<int64_t> stand(kSystemAxes, 0);
    for (const Other& other : kOthers) {
        const Part part("pulses.ngc", ref::Holds::kBounds, other.change);
        host_.prepare(part_);
        const uint32_t word = CURVECORE_PUT(
            STATE_MOTION, CURVECORE_STATE_MOTION_SEGMENT_WORD | CURVECORE_STATE_MOTION_PIECE_WORD);
        const auto push = [&](uint32_t address, const std::vector<uint64_t>& words, std::size_t n) {
            if (n < words.size() && !host_.is(word)) host_.push(address, words[n]);
        };
        for (std::size_t n = 0; n < 100; ++n) {  // the queues have room for them
            push(CURVECORE_SEGMENT_LO, part.segments, n);
            push(CURVECORE_PROFILE_LO, part.pieces, n);
        }
        host_.samples(200);
        EXPECT_NE(host_.state() & word, 0U) << other.what;
        EXPECT_EQ(host_.state() & kFaults & ~word, 0U) << other.what;
        EXPECT_EQ(host_.path(), 0U) << other.what;
        EXPECT_EQ(counts(), stand) << other.what;
        EXPECT_TRUE(host_.write(CURVECORE_CONTROL, 0));
        host_.samples(20);
        clear_faults();
        EXPECT_TRUE(host_.is(CURVECORE_STATE_CLEAN_MASK)) << other.what;
    }
    // A fresh start
    host_.prepare(part_);
    host_.draw(part_);
    expect_drawn();
}

}  // namespace
}  // namespace curvecore::tb
