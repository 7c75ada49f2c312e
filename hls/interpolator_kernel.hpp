// SPDX-License-Identifier: Apache-2.0
// A stream of segments, followed along the path: the present segment, step and sample.
// Twin: rtl/sampler/step_tracker.sv (and the landing in rtl/spherical_interpolator.sv).
//
// A step covers [m 2^k, (m+1) 2^k) of the segment's path, the last one [m 2^k, length]: a segment
// is left when the path goes beyond its length, the rest goes into the next segment. A sample
// exactly at the segment's length is its end word: stops land without error.
#pragma once

#include "hls/curves/arc.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// The interpolator over a kernel with load(words), step(), sample(sigma, out), as ArcCurve.
template <class C, class Kernel = ArcCurve<C>>
class InterpolatorKernel : private C {
  public:
    using Length = Word<kLengthBits + 1>;
    using Fine = typename C::Fine;

    InterpolatorKernel() = default;
    explicit InterpolatorKernel(const C& format) : C(format), kernel_(format) {}

    /// Moves ds quanta along the path and returns the fine position there. `next_segment()` gives
    /// the next segment's words; it is called only when the path has left the present one.
    template <class NextSegment>
    void sample(const Length& ds, NextSegment&& next_segment, Fine* out) {
        if (segments_ == 0) {
            open(next_segment);
        }
        sigma_ = Length(sigma_ + ds);
        while (sigma_ > step_length_ || (sigma_ == step_length_ && !last_step())) {
            sigma_ = Length(sigma_ - step_length_);
            if (last_step()) {
                open(next_segment);
            } else {
                rest_ = Length(rest_ - step_length_);
                kernel_.step();
                measure();
            }
        }
        if (sigma_ == rest_) {
            for (int axis = 0; axis < C::kAxes; ++axis) {
                out[axis] = segment_.end[axis];
            }
        } else {
            kernel_.sample(sigma_, out);
        }
    }

    /// Number of steps and segments begun so far, and of segments consumed because they had no
    /// length.
    std::int64_t steps() const { return steps_; }
    std::int64_t segments() const { return segments_; }
    std::int64_t empty_segments() const { return empty_segments_; }

  private:
    bool last_step() const { return rest_ == step_length_; }

    /// Returns the next segment with a length; the others are consumed and counted.
    template <class NextSegment>
    void open(NextSegment&& next_segment) {
        segment_ = next_segment();
        while (segment_.length == 0) {
            ++empty_segments_;
            segment_ = next_segment();
        }
        ++segments_;
        rest_ = segment_.length;
        kernel_.load(segment_);
        measure();
    }

    void measure() {
        const Length full = Length(Length(1) << (segment_.step_exponent + kPathFrac));
        step_length_ = rest_ < full ? rest_ : full;
        ++steps_;
    }

    Kernel kernel_;
    SegmentWords<C> segment_;
    Length sigma_ = 0;        // offset into the present step
    Length rest_ = 0;         // from the present step's start to the segment's end
    Length step_length_ = 0;  // length of the present step
    std::int64_t steps_ = 0;
    std::int64_t segments_ = 0;
    std::int64_t empty_segments_ = 0;
};

/// Rounds a fine position to the output word, whole length units, once.
template <class C>
inline typename C::Position to_position(const typename C::Fine& fine, const C& c = C()) {
    return typename C::Position(round_shift(fine, c.kGuardBits));
}

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
