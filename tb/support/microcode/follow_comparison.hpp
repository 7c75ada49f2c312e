// SPDX-License-Identifier: Apache-2.0
// Samples of streams of segments, rtl/engine/programs/follow.asm and segment.asm with the programs
// of the curves, beside those of hls::MotionKernel.
#pragma once

#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/follow_assembler.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/microcode/curve_comparison.hpp"

namespace curvecore::tb {

constexpr char kOfFollowTest[] = "follow_microcode_test";
constexpr int kFollowReset = 0;
constexpr int kFollowCall = 1;
constexpr int kCallClocks = 28;          // of call_follow besides follow
constexpr int kQueueBegin = 32768 - 60;  // its end has a limb more
constexpr int kQueueFrames = 3;
constexpr int kEntries = 3;
constexpr int kEmpties = 30;
constexpr int kEmptiesBefore = 32767;

inline assembler::Assembly follow_microcode(const sysc::CoreParameters& core,
                                            const assembler::StoreSize& size = {}, int less = 0) {
    assembler::Assembly assembly(size);
    MicrocodeMachine::dispatch(assembly, {"reset", "call_follow"});
    const std::string programs = std::string(RTL_DIR) + "/engine/programs";
    const int frame = kEntries * core.segment_words();
    assembly.define("segment_begin", kQueueBegin);
    assembly.define("segment_end", kQueueBegin + kQueueFrames * frame + less);
    assemble_source(programs + "/ports.asm", assembly);
    std::vector<ref::CurveTable> tables{
        ref::read_curve_table(std::string(CURVES_DIR) + "/arc.net")};
    if (core.splines != 0) {
        tables.push_back(ref::read_curve_table(std::string(CURVES_DIR) + "/spline.net"));
    }
    assemble_follow(programs, tables, core, assembly);
    assemble_text(kOfFollowTest,
                  "word returned = 0\n"
                  "word test_ds sigma\n"
                  "call_follow:\n"
                  "sigma = sigma + test_ds, 4 limbs\n"
                  "call follow\n"
                  "returned = returned + 1\n"
                  "go to idle\n"
                  "reset:\n",
                  assembly);
    assembly.put_starts();
    assemble_text(kOfFollowTest, "return\n", assembly);
    assembly.finish();
    return assembly;
}

/// Clocks of a sample within a step, and those that a step, a segment come on top with: at most.
struct FollowClocks {
    int sample = 0;
    int step = 0;
    int segment = 0;
};

inline FollowClocks bounds_of(const assembler::Assembly& of) {
    const int again = worst_case(of, "in_step", {"leave_step", "curve_sample", "land"});
    return {worst_case(of, "follow", {"leave_step"}),
            worst_case(of, "leave_step", {"in_step", "open_segment"}) + again,
            worst_case(of, "leave_step", {"in_step", "curve_step", "no_length"}) + again};
}

/// Samples of both, one after the other.
class FollowComparison {
  public:
    FollowComparison(const sysc::CoreParameters& core, const assembler::Assembly& assembly,
                     MicrocodeMachine& machine, std::uint32_t seed)
        : core_(core),
          bounds_(bounds_of(assembly)),
          machine_(machine),
          random_(seed),
          ranges_(core.coef_bits),
          format_(core, core.axes(), &ranges_),
          kernel_(format_),
          words_of_frame_(core.segment_words()) {
        machine_.ports().memory.assign(
            kQueueBegin + kQueueFrames * kEntries * static_cast<std::size_t>(words_of_frame_), -1);
        write_powers(machine_.ports().memory);
        machine_.reset(kFollowReset);
        machine_.set("empty_segments", kEmptiesBefore);
        machine_.set("segments", 0);
        machine_.set("segment_words", 0);
        machine_.ports().take = [this](int port, int limb, std::int16_t value) {
            if (port != kEmpties) return;
            told_empty_ = limb == 0 ? value : told_empty_ + value * (std::int64_t{1} << 15);
        };
    }
    FollowComparison(const FollowComparison&) = delete;

    /// Returns the number of words that differ.
    int sample() {
        const std::int64_t ds = covered_ == 0 && random_() % 2 == 0 ? 0 : next_ds();
        std::int64_t fine[sysc::kMostAxes];
        const Kernel before = kernel_;
        kernel_.sample(
            ds, [this] { return taken_by_kernel(); }, fine);
        walked_ += ds;
        while (random_() % 3 == 0 && put_ != stream_.size() && queued() < kQueueFrames) put();
        machine_.set("test_ds", ds);
        const int clocks = follow() - kCallClocks;
        int differ = machine_.get("waits") != 0 || in_time(clocks, before) ? 0 : 1;
        machine_.set("test_ds", 0);
        while (machine_.get("waits") != 0) {
            const bool waits = machine_.get("waits") == 1 && machine_.get("segments") == 0;
            if (!waits || put_ == stream_.size()) return 1;
            if (random_() % 4 == 0) follow();  // in vain
            put();
            follow();
        }
        differ += machine_.get("returned") == calls_ ? 0 : 1;
        for (int axis = 0; axis < core_.axes(); ++axis) {
            differ += machine_.get("fine" + row(axis), axis < 3 ? axis : 0) == fine[axis] ? 0 : 1;
        }
        const std::int64_t empties = kEmptiesBefore + kernel_.empty_segments();
        differ += machine_.get("empty_segments") == empties ? 0 : 1;
        differ += machine_.get("segment_words") == queued() * words_of_frame_ ? 0 : 1;
        differ += told_empty_ == empties ? 0 : 1;
        words_ += core_.axes() + 4;
        return differ;
    }

    std::int64_t words() const { return words_; }
    const FollowClocks& bounds() const { return bounds_; }
    const FollowClocks& most() const { return most_; }
    std::int64_t landings() const { return landings_; }
    const sysc::RunTimeKernel& kernel() const { return kernel_; }
    const sysc::ValueRanges& ranges() const { return ranges_; }

  private:
    using Kernel = sysc::RunTimeKernel;

    int follow() {
        ++calls_;
        return machine_.run(kFollowCall);
    }

    /// Returns whether a sample kept the bounds.
    bool in_time(int clocks, const Kernel& before) {
        const auto segments = static_cast<int>(kernel_.segments() - before.segments());
        const auto steps = static_cast<int>(kernel_.steps() - before.steps()) - segments;
        const auto empty = static_cast<int>(kernel_.empty_segments() - before.empty_segments());
        const int over = clocks - bounds_.sample;
        if (steps + segments + empty == 0) most_.sample = std::max(most_.sample, clocks);
        if (steps == 1 && segments + empty == 0) most_.step = std::max(most_.step, over);
        if (segments == 1 && steps + empty == 0) most_.segment = std::max(most_.segment, over);
        return over <= steps * bounds_.step + (segments + empty) * bounds_.segment;
    }

    static std::string row(int axis) { return axis < 3 ? "[k]" : "[" + std::to_string(axis) + "]"; }

    /// Segments that the engine's queue holds.
    int queued() { return static_cast<int>(machine_.get("segments")); }

    /// Path of the next sample: none, into the present step, to the end of it or of the present
    /// segment, beyond steps and segments.
    std::int64_t next_ds() {
        const std::int64_t left = covered_ - walked_;
        const auto part = [&](std::int64_t most) {
            return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(most + 1));
        };
        switch (random_() % 16) {
            case 0:
                return 0;
            case 1:
                ++landings_;
                return left;
            case 2:
                return left + part(left + 2);
            case 3:
                return std::min(left, step_ - (walked_ - begin_) % step_);
            case 4:
                return part(3 * step_);
            default:
                return part(step_ / 8);
        }
    }

    sysc::RunSegment taken_by_kernel() {
        while (stream_.size() < taken_ + 1 + kQueueFrames) make();
        const sysc::RunSegment& segment = stream_[taken_++];
        begin_ = covered_;
        covered_ += segment.length;
        step_ = std::int64_t{1} << (segment.step_exponent + hls::kPathFrac);
        return segment;
    }

    /// A further segment, up to 3 steps long, with what lies above the fields.
    void make() {
        CurveCase of;
        of.core = core_;
        of.spline = core_.splines != 0 && random_() % 2 == 0;
        sysc::RunSegment segment = random_segment(of, random_);
        const std::int64_t step = std::int64_t{1} << (segment.step_exponent + hls::kPathFrac);
        const auto steps = static_cast<std::int64_t>(random_() % 3);
        switch (random_() % 8) {
            case 0:
                segment.length = 0;
                break;
            case 1:
                segment.length = (steps + 1) * step;
                break;
            case 2:
                segment.length = steps * step + 1;
                break;
            default:
                segment.length =
                    steps * step + 1 +
                    static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(step));
        }
        segment.length = std::min(segment.length, (std::int64_t{1} << hls::kLengthField.bits) - 1);
        segment.last = random_() % 2 == 0;
        segment.other_turn = random_() % 2 == 0;
        segment.ticks = static_cast<std::uint32_t>(random_());
        for (int axis = 0; axis < core_.axes(); ++axis) {
            segment.end[axis] = segment.start[axis] + static_cast<std::int64_t>(random_() % 100);
        }
        stream_.push_back(segment);
    }

    /// The next frame into the engine's queue, as words.asm does it.
    void put() {
        std::vector<std::uint64_t> frame(static_cast<std::size_t>(words_of_frame_));
        hls::pack(stream_[put_], static_cast<unsigned>(put_), frame.data(), format_);
        for (std::size_t n = 0; n < frame.size(); ++n) {
            // A check stands above an advance, a random one here.
            if (hls::get(hls::kTagField, frame[n]) == static_cast<int>(hls::Tag::kAdvance)) {
                frame[n] |= hls::put(hls::kCheckField, static_cast<std::int64_t>(random_() & 0xff));
            }
            const auto at = static_cast<std::size_t>(kQueueBegin) +
                            kEntries * (put_ % kQueueFrames * frame.size() + n);
            std::int16_t* entries = &machine_.ports().memory[at];
            entries[0] = static_cast<std::int16_t>(frame[n] & 0x7fff);
            entries[1] = static_cast<std::int16_t>(frame[n] >> 15 & 0x7fff);
            entries[2] = static_cast<std::int16_t>(frame[n] >> 30 & 0xffff);
        }
        ++put_;
        machine_.set("segments", machine_.get("segments") + 1);
        machine_.set("segment_words", machine_.get("segment_words") + words_of_frame_);
    }

    sysc::CoreParameters core_;
    FollowClocks bounds_;
    FollowClocks most_;
    MicrocodeMachine& machine_;
    std::mt19937_64 random_;
    sysc::ValueRanges ranges_;
    sysc::RunTimeFormat format_;
    Kernel kernel_;
    int words_of_frame_;
    std::vector<sysc::RunSegment> stream_;
    std::size_t taken_ = 0;   // by the kernel
    std::size_t put_ = 0;     // into the engine's queue
    std::int64_t begin_ = 0;  // of the present segment, and its end
    std::int64_t covered_ = 0;
    std::int64_t walked_ = 0;
    std::int64_t step_ = 1 << 20;
    std::int64_t words_ = 0;
    std::int64_t landings_ = 0;
    std::int64_t calls_ = 0;
    std::int64_t told_empty_ = kEmptiesBefore;
};

}  // namespace curvecore::tb
