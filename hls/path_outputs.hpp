// SPDX-License-Identifier: Apache-2.0
// Outputs that change at places of the path: bits, and a level that may follow the path's speed.
// Twin: rtl/output/path_outputs.sv.
//
// A change is due in the first sample that is at its place or beyond. Its place is that of the
// change before it, or the path's begin, and its distance.
//
//   | kind   | value                                                                            |
//   |--------|----------------------------------------------------------------------------------|
//   | bits   | all of them, in [7:0]                                                            |
//   | level  | 0 .. 4095 of 4095                                                                |
//   | follow | 0: the level at any speed; 1: at any but 0; else e [11:7], m [6:0]: w / F of it,   |
//   |        | at most all, where w is the way of a sample and F the one at which it is whole    |
//
// w counts 2^-8 length unit, and w / F is rounded down twice:
//
//   x = floor(2^12 w / 2^e), at most 8191;  q = floor(x (128 + m) / 256), 4096 at F
//   power = q < 4096 ? floor(level q / 4096) : level
//
// So F = 2^e 2^8 / (128 + m) of these: more than kLeastWay and less than kGreatestWay length units
// (ref/format/path_words.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

#include "hls/words.hpp"
#include "ref/plan/planned_output.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

using ref::OutputKind;

constexpr std::uint32_t kMostLevel = mask(kOutputValueField);
constexpr int kOutputPathFrac = 8;  // fraction bits of the path of a sample
constexpr int kFollowShift = 12;    // w before it is scaled

struct OutputChange {
    OutputKind kind = OutputKind::kBits;
    std::uint32_t value = 0;
    std::uint32_t distance = 0;  // length units
};

inline std::uint64_t pack(const OutputChange& change, unsigned number) {
    return put(kTagField, static_cast<int>(Tag::kOutput)) |
           put(kOutputDistanceField, change.distance) | put(kOutputValueField, change.value) |
           put(kOutputKindField, static_cast<int>(change.kind)) | put(kOutputNumberField, number);
}

/// Ways of the samples, some samples later: the tool is as far behind the path with a shaper.
class WayDelay {
  public:
    /// Sets the samples, fewer than the core keeps, while nothing moves.
    void set(int samples) { samples_ = static_cast<std::size_t>(samples); }

    /// Takes the way of a period; returns the one that counts in it.
    std::uint32_t next(std::uint32_t way) {
        ways_.push_front(way);
        if (ways_.size() > kMost) ways_.pop_back();
        return samples_ < ways_.size() ? ways_[samples_] : 0;
    }
    void clear() { ways_.clear(); }

    /// Returns true if no way is to come.
    bool settled() const {
        const auto end =
            ways_.begin() + static_cast<std::ptrdiff_t>(std::min(samples_, ways_.size()));
        return std::all_of(ways_.begin(), end, [](std::uint32_t way) { return way == 0; });
    }

  private:
    static constexpr std::size_t kMost = 512;
    std::size_t samples_ = 0;
    std::deque<std::uint32_t> ways_;
};

class PathOutputs {
  public:
    /// Sets the samples by which all is later, while nothing moves.
    void delay(int samples) { delay_.set(samples); }

    /// Takes a word. Returns false, and takes nothing, if it is not a change, or not the next one.
    bool take(std::uint64_t word) {
        const bool valid = get(kTagField, word) == static_cast<std::uint64_t>(Tag::kOutput) &&
                           get(kOutputKindField, word) <= 2 &&
                           get(kOutputNumberField, word) == (number_ & mask(kOutputNumberField));
        if (!valid) return false;
        ++number_;
        waiting_.push_back({static_cast<OutputKind>(get(kOutputKindField, word)),
                            static_cast<std::uint32_t>(get(kOutputValueField, word)),
                            static_cast<std::uint32_t>(get(kOutputDistanceField, word))});
        settle();
        return true;
    }

    /// Goes on to a sample at this path, in quanta.
    void sample(std::uint64_t path) {
        const auto place = static_cast<std::uint32_t>(path >> (kRateFrac - kOutputPathFrac));
        go(place - before_);
        before_ = place;
    }

    /// Goes on through a period without a sample, of a core with a shaper.
    void none() { go(0); }

    /// Drops what waits; the path begins at 0. What is on stays on, or goes off.
    void flush(bool keep) {
        if (!keep) bits_ = level_ = follow_ = 0;
        waiting_.clear();
        number_ = 0;
        left_ = 0;
        counted_ = false;
        before_ = 0;
        delay_.clear();
    }

    unsigned bits() const { return bits_; }
    bool settled() const { return delay_.settled(); }

    /// Returns what the pin is on, of 4095.
    std::uint32_t power() const {
        if (follow_ <= 1) return follow_ == 1 && way_ == 0 ? 0 : level_;
        const std::uint64_t scaled = (std::uint64_t(way_) << kFollowShift) >> (follow_ >> 7);
        const std::uint32_t x = scaled > 8191 ? 8191 : static_cast<std::uint32_t>(scaled);
        const std::uint32_t q = x * (128 + (follow_ & 127)) >> 8;
        return q < 4096 ? level_ * q >> 12 : level_;
    }

    std::size_t waiting() const { return waiting_.size(); }

  private:
    void go(std::uint32_t way) {
        way_ = delay_.next(way);
        left_ -= way_;
        settle();
    }
    void settle() {
        while (!waiting_.empty()) {
            const OutputChange& next = waiting_.front();
            if (!counted_) left_ += std::int64_t(next.distance) << kOutputPathFrac;
            counted_ = left_ > 0;
            if (counted_) return;
            if (next.kind == OutputKind::kBits) bits_ = next.value & 255;
            if (next.kind == OutputKind::kLevel) level_ = next.value;
            if (next.kind == OutputKind::kFollow) follow_ = next.value;
            waiting_.pop_front();
        }
    }

    WayDelay delay_;
    std::deque<OutputChange> waiting_;
    unsigned number_ = 0;
    std::int64_t left_ = 0;  // way to the next change
    bool counted_ = false;   // its distance is in it
    std::uint32_t before_ = 0;
    std::uint32_t way_ = 0;
    unsigned bits_ = 0;
    std::uint32_t level_ = 0;
    std::uint32_t follow_ = 0;
};

/// Returns the value of kFollow at which the level is whole at a way of `units` length units a
/// sample, above ref::kLeastWay and below ref::kGreatestWay, to 0.4 %.
inline std::uint32_t follow_at(double units) {
    double scaled = units * (1 << (kOutputPathFrac + kFollowShift));  // x at e = 0
    std::uint32_t e = 0;
    for (; scaled >= 8192; ++e) scaled /= 2;
    const std::uint32_t least = e == 0 ? 130 : 128;  // 0 and 1 do not follow
    const auto factor = static_cast<std::uint32_t>(std::lround(4096 * 256 / scaled));
    return e << 7 | (std::min<std::uint32_t>(std::max(factor, least), 255) - 128);
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
