// SPDX-License-Identifier: Apache-2.0
// Words that take the engine's time: pieces, branches, steps and segments as often as a planner may
// send them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "hls/word_check.hpp"
#include "sysc/core/core_clocks.hpp"
#include "tb/support/microcode/curve_comparison.hpp"
#include "tb/support/segments/random_pieces.hpp"
#include "tb/support/segments/word_rule.hpp"

namespace curvecore::tb {

struct TimeCase {
    bool spline = false;
    int mode = 0;
    int samples_per_tick_log2 = 0;
    int piece_ticks = 1;  // of a piece, at most
    bool branches = false;
    int segment_steps = 1;
    bool moves = false;  // overrides and holds
    bool slow_host = false;

    int most_wait() const { return slow_host ? 60 : 200; }
    /// Ticks from full rate to a stop: those of the longest branch, if words may run low.
    int stop_ticks() const { return slow_host && branches ? most_wait() + 2 * 32 + 6 : 30; }
};

inline std::string text(const TimeCase& of) {
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
    BusyProgram(const sysc::CoreParameters& core, const TimeCase& of, std::uint16_t digest,
                std::uint32_t seed)
        : core_(core), of_(of), digest_(digest), random_(seed), format_(core, core.axes()) {
        const int window = 1 + hls::samples_ahead(sysc::timed_core(core));
        speed_ = kStep << of.samples_per_tick_log2;
        speed_ /= window;  // quanta in a tick
    }

    /// The next word of a stream, and the one after it from then on.
    std::uint64_t next(Stream stream) {
        while (words_[stream].empty()) add();
        const std::uint64_t word = words_[stream].front();
        words_[stream].pop_front();
        ++taken_[stream];
        return word;
    }
    /// Segments that were taken.
    std::int64_t segments() const {
        return taken_[kSegments] / ref::segment_bus_words(core_.aux_axes);
    }

  private:
    static constexpr int kStepExponent = 10;
    static constexpr std::int64_t kStep = std::int64_t{1} << (kStepExponent + hls::kPathFrac);

    void add() {
        constexpr int kSegmentsOfOne = 30;
        const std::int64_t length = kStep * of_.segment_steps;
        std::int64_t path = kSegmentsOfOne * length;
        std::int64_t ticks = 0;
        hls::WordCheck check(digest_);
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
        hls::WordCheck segment_check(digest_);
        for (int n = 0; n < kSegmentsOfOne; ++n) {
            sysc::RunSegment words = segment(length);
            words.last = n + 1 == kSegmentsOfOne;
            // Every piece has this speed, but the last, which may be slower.
            const std::int64_t end = words.last ? ticks : (n + 1) * length / speed_;
            words.ticks = static_cast<std::uint32_t>(end - n * length / speed_);
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
        words.push_back(hls::pack_stop(static_cast<std::int32_t>(1 + random_() % of_.most_wait())));
        const int steps = std::min(2 * ticks, 1 << random_() % (of_.slow_host ? 6 : 9));
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
            words.start[axis] = end_[axis];
            end_[axis] = words.end[axis] = static_cast<std::int64_t>(random_() % 100000);
        }
        return words;
    }

    sysc::CoreParameters core_;
    TimeCase of_;
    std::uint16_t digest_;
    std::mt19937_64 random_;
    sysc::RunTimeFormat format_;
    std::int64_t speed_;
    std::deque<std::uint64_t> words_[2];
    std::int64_t taken_[2] = {};
    std::int32_t last_ticks_ = 1 << 20;
    unsigned piece_number_ = 0;
    unsigned segment_number_ = 0;
    std::int64_t end_[sysc::kMostAxes] = {};
};

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

}  // namespace curvecore::tb
