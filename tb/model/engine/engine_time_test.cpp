// SPDX-License-Identifier: Apache-2.0
// No sample of the engine is late in the least period that planner and boards ask for
// (least_period_clocks), whatever pieces, branches, holds and overrides come, while its host offers
// words all the time, or too few. In a shorter period samples are late.
#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include "tb/model/engine/timed_motion.hpp"
#include "tb/support/microcode/curve_comparison.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/segments/random_pieces.hpp"

namespace curvecore::tb {
namespace {

struct TimeCase {
    bool spline = false;
    int mode = 0;
    int samples_per_tick_log2 = 0;
    int piece_ticks = 1;  // of a piece, at most
    bool branches = false;
    int segment_steps = 1;
    bool moves = false;  // overrides and holds
    bool slow_host = false;
};

std::string text(const TimeCase& of) {
    std::ostringstream out;
    out << (of.spline ? "splines" : "arcs") << ", Mode " << of.mode << ", 2^"
        << of.samples_per_tick_log2 << " samples a tick, pieces of " << of.piece_ticks
        << (of.branches ? ", branches" : "") << (of.moves ? ", moves" : "")
        << (of.slow_host ? ", a slow host" : "");
    return out.str();
}

/// Programs without an end, along which a step or a segment begins once in a window of samples.
class BusyProgram {
  public:
    BusyProgram(const sysc::CoreParameters& core, const TimeCase& of, std::uint32_t seed)
        : core_(core), of_(of), random_(seed), format_(core, core.axes()) {
        const int window = 1 + hls::samples_ahead(sysc::timed_core(core));
        speed_ = kStep << of.samples_per_tick_log2;
        speed_ /= window;  // quanta in a tick
    }

    /// Offers words until so many of each stream wait.
    void offer(TimedMotion& to, std::size_t count) {
        for (const Stream stream : {kSegments, kPieces}) {
            for (; to.offered(stream).size() < count; words_[stream].pop_front()) {
                if (words_[stream].empty()) add();
                to.offered(stream).push_back(words_[stream].front());
                ++offered_[stream];
            }
        }
    }
    /// Segments that were offered.
    std::int64_t segments() const {
        return offered_[kSegments] / ref::segment_bus_words(core_.aux_axes);
    }

  private:
    static constexpr int kStepExponent = 10;
    static constexpr std::int64_t kStep = std::int64_t{1} << (kStepExponent + hls::kPathFrac);

    void add() {
        constexpr int kSegmentsOfOne = 30;
        const std::int64_t length = kStep * of_.segment_steps;
        std::int64_t path = kSegmentsOfOne * length;
        std::int64_t ticks = 0;
        hls::WordCheck check(TimedMotion::kDigest);
        while (path > 0) {
            auto n = static_cast<std::int32_t>(1 + random_() % of_.piece_ticks);
            std::int64_t ds = n * speed_;
            const bool final = ds >= path;
            ds = std::min(ds, path);
            path -= ds;
            ticks += n;
            std::vector<std::uint64_t> frame = branch(last_ticks_);
            last_ticks_ = n;
            frame.resize(frame.size() + hls::kProfileBusWords);
            hls::pack(piece_of(ds, n, 1, final), piece_number_++,
                      &frame[frame.size() - hls::kProfileBusWords]);
            add(check, frame, kPieces);
        }
        hls::WordCheck segment_check(TimedMotion::kDigest);
        for (int n = 0; n < kSegmentsOfOne; ++n) {
            sysc::RunSegment words = segment(length);
            words.last = n + 1 == kSegmentsOfOne;
            words.ticks = static_cast<std::uint32_t>(words.last ? ticks : ticks / kSegmentsOfOne);
            if (!words.last) left_ += words.ticks;
            if (words.last) words.ticks -= std::exchange(left_, 0);
            std::vector<std::uint64_t> frame(
                static_cast<std::size_t>(ref::segment_bus_words(core_.aux_axes)));
            hls::pack(words, segment_number_++, frame.data(), format_);
            add(segment_check, frame, kSegments);
        }
    }

    void add(hls::WordCheck& check, std::vector<std::uint64_t>& frame, Stream stream) {
        check.seal(frame.data(), frame.size());
        words_[stream].insert(words_[stream].end(), frame.begin(), frame.end());
    }

    /// A branch behind a piece of so many ticks: the engine takes two of its steps in each.
    std::vector<std::uint64_t> branch(std::int32_t ticks) {
        std::vector<std::uint64_t> words;
        if (!of_.branches || random_() % 4 == 0) return words;
        words.push_back(hls::pack_stop(static_cast<std::int32_t>(1 + random_() % 200)));
        const int steps = std::min(2 * ticks, 1 << random_() % 9);
        for (int n = 1; n <= steps; ++n) {
            hls::StopStep step;
            step.ticks = 1 + static_cast<std::int32_t>(random_() % 2);
            step.change = -static_cast<std::int32_t>(random_() % (1 << 24));
            step.last = n == steps;
            words.push_back(hls::pack(step));
        }
        return words;
    }

    sysc::RunSegment segment(std::int64_t length) {
        CurveCase of{of_.spline, core_};
        sysc::RunSegment words = random_segment(of, random_);
        words.lambda = of_.spline ? words.lambda + kStepExponent - words.step_exponent : 0;
        words.step_exponent = kStepExponent;
        words.length = length;
        for (int axis = 0; axis < core_.axes(); ++axis) {
            if (joined_) words.start[axis] = end_[axis];
            end_[axis] = words.end[axis] = static_cast<std::int64_t>(random_() % 100000);
        }
        joined_ = true;
        return words;
    }

    sysc::CoreParameters core_;
    TimeCase of_;
    std::mt19937_64 random_;
    sysc::RunTimeFormat format_;
    std::int64_t speed_;
    std::deque<std::uint64_t> words_[2];
    std::int64_t offered_[2] = {};
    std::int32_t last_ticks_ = 1 << 20;
    unsigned piece_number_ = 0;
    unsigned segment_number_ = 0;
    std::int64_t end_[sysc::kMostAxes] = {};
    bool joined_ = false;
    std::uint32_t left_ = 0;  // ticks that the program's segments so far have
};

struct Drawn {
    std::int64_t late = 0;
    std::int64_t moving = 0;    // samples with a program under way
    std::int64_t segments = 0;  // that were offered
    unsigned reported = 0;
};

/// Draws with a period that is a share of the least one.
Drawn draw(const TimeCase& of, double share, int samples) {
    sysc::CoreParameters core;
    core.build = ref::Build::kEngine;
    core.splines = 1;
    core.mode = of.mode;
    constexpr int kRateBits = 29;  // as in motion_system
    const assembler::Assembly made =
        assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..", kRateBits);
    const double least = sysc::least_period_clocks(core, of.spline, 1 << of.samples_per_tick_log2);
    TimedMotion motion(core, made, static_cast<int>(std::ceil(share * least)));
    motion.inputs().samples_per_tick_log2 = of.samples_per_tick_log2;
    if (of.moves && !of.slow_host) motion.inputs().hold_acceleration = 1 << 12;
    BusyProgram program(core, of, 1);
    std::mt19937_64 random(2);
    Drawn drawn;
    for (std::int64_t n = 0; n < samples; ++n) {
        program.offer(motion, of.slow_host ? 1 : 128);
        if (of.moves) {
            motion.inputs().hold = random() % 64 == 0;
            motion.inputs().override_rate = 65536 - static_cast<std::int64_t>(random() % 3000);
        }
        motion.work();
        drawn.moving += motion.active() ? 1 : 0;
    }
    drawn.late = motion.late();
    drawn.reported = motion.reported();
    drawn.segments = program.segments();
    return drawn;
}

template <class Visit>
void each_case(Visit&& visit) {
    for (int n = 0; n < 96; ++n) {
        constexpr int kTicks[] = {1, 3, 80};
        TimeCase of;
        of.spline = n % 2 != 0;
        of.mode = n / 2 % 2;
        of.samples_per_tick_log2 = n / 4 % 2 * 2;
        of.moves = n / 8 % 2 != 0;
        of.slow_host = n / 16 % 2 != 0;
        of.piece_ticks = kTicks[n / 32];
        of.branches = of.piece_ticks > 1;
        of.segment_steps = of.piece_ticks == 3 ? 3 : 1;
        visit(of);
    }
}

TEST(EngineTime, NoSampleIsLateInTheLeastPeriod) {
    constexpr unsigned kUnderrun = 256;
    int starved = 0;
    each_case([&](const TimeCase& of) {
        const int samples = cases(600, 20000);
        const Drawn drawn = draw(of, 1, samples);
        EXPECT_EQ(drawn.late, 0) << text(of);
        EXPECT_EQ(drawn.reported & ~kUnderrun, 0U) << text(of);
        if (of.slow_host) {
            starved += drawn.reported != 0 ? 1 : 0;
        } else {
            EXPECT_GT(drawn.moving, samples / 2) << text(of);
            EXPECT_GT(drawn.segments, samples / 15 / of.segment_steps / 2) << text(of);
        }
    });
    EXPECT_GT(starved, 20);
}

/// The bound is the sum of the longest ways, which do not come together.
TEST(EngineTime, SamplesAreLateInAShorterPeriod) {
    each_case([&](const TimeCase& of) {
        if (of.piece_ticks == 80 && of.samples_per_tick_log2 == 0 && !of.slow_host) {
            EXPECT_GT(draw(of, of.spline ? 0.55 : 0.4, 600).late, 0) << text(of);
        }
    });
}

}  // namespace
}  // namespace curvecore::tb
