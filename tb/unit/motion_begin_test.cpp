// SPDX-License-Identifier: Apache-2.0
// How a program begins on rtl/motion_system.sv: at which rate, and from where.
#include <gtest/gtest.h>

#include <cmath>

#include "tb/support/motion_system_bench.hpp"

namespace curvecore::tb {
namespace {

using MotionBegin = MotionSystem;

/// Each of the part's points is so many steps away.
void move(Part& part, const std::vector<double>& steps) {
    hls::WordCheck check;
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
    host_.samples(50);  // samples are asked for, at the full rate
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
        RegisterHost::Sent sent;  // a segment says where
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

/// The steps that were made say where: the path's place is less than a step from there.
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

}  // namespace
}  // namespace curvecore::tb
