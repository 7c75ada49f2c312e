// SPDX-License-Identifier: Apache-2.0
// Every sample of the RTL against the kernel's prediction, bit for bit, and against the exact curve
// at the same path length.
#pragma once

#include <fmt/format.h>

#include "hls/curve_kernel.hpp"
#include "ref/curve/curve_follower.hpp"
#include "tb/program/check_result.hpp"
#include "tb/program/job.hpp"
#include "tb/program/path_cursor.hpp"
#include "tb/program/path_source.hpp"
#include "tb/program/pictures.hpp"
#include "tb/program/samples_writer.hpp"

namespace curvecore::tb {

/// One request as the core got it, and the sample that it gave.
template <class C>
struct RtlSample {
    std::int64_t ds = 0;
    std::int32_t rate = 0;
    std::int64_t position[C::kAxes] = {};
    std::int64_t fine[C::kAxes] = {};
};

template <class C>
class Checker {
  public:
    Checker(const Job& job, const std::vector<hls::SegmentWords<C>>& segments,
            SamplesWriter& samples, Pictures& pictures)
        : job_(job),
          segments_(segments),
          source_(job.plan, job.options.samples_per_tick_log2(), job.options.override_word()),
          cursor_(job.plan),
          samples_(samples),
          pictures_(pictures),
          axes_(3 + job.plan.aux_axes),
          chord_tolerance_(std::max(0.1, 2 * std::sqrt(3.0) * job.bound())) {
        start();
    }

    void take(const RtlSample<C>& rtl) {
        ++result_.samples;
        const bool tick = source_.next();
        compare_with_kernel(rtl);
        const double share = std::ldexp(static_cast<double>(source_.tick_ds()),
                                        -job_.options.samples_per_tick_log2());
        result_.increment =
            std::max(result_.increment, std::abs(static_cast<double>(rtl.ds) - share));
        cursor_.advance(static_cast<std::uint64_t>(rtl.ds));
        if (tick) {
            pictures_.tick(source_.tick_ds(), curve_.curvature(cursor_.segment(), cursor_.local()));
        }
        compare_with_curve(rtl);
        if (cursor_.at_end() && stops(cursor_.index())) compare_landing(rtl);
        samples_.row(result_.samples, cursor_.index(), cursor_.s(), rtl.position);
    }

    const CheckResult& result() const { return result_; }

  private:
    static constexpr double kFineUnit = 1.0 / (1 << C::kGuardBits);
    static constexpr double kRest = 1e-6;  // mm/s: words round, a stop ends a little above zero

    /// The sample before the first request: the start words.
    void start() {
        const hls::SegmentWords<C>& first = segments_[cursor_.index()];
        std::int64_t position[C::kAxes];
        for (int axis = 0; axis < C::kAxes; ++axis) {
            position[axis] = hls::to_position<C>(first.start[axis]);
            if (axis < 3) {
                last_point_[axis] = static_cast<double>(first.start[axis]) * kFineUnit;
            }
        }
        last_curve_ = cursor_.segment().start;
        samples_.row(0, cursor_.index(), 0, position);
        pictures_.sample(0, cursor_.index(), last_curve_, true);
    }

    void compare_with_kernel(const RtlSample<C>& rtl) {
        hls::Word<C::kFineBits> fine[C::kAxes];
        kernel_.sample(
            source_.ds(),
            [this]() -> const hls::SegmentWords<C>& {
                if (next_segment_ == segments_.size()) {
                    throw std::logic_error("the profile is longer than the segments");
                }
                return segments_[next_segment_++];
            },
            fine);
        int differing = (rtl.ds != source_.ds()) + (rtl.rate != source_.rate());
        for (int axis = 0; axis < C::kAxes; ++axis) {
            differing += rtl.fine[axis] != fine[axis];
            differing += rtl.position[axis] != hls::to_position<C>(fine[axis]);
        }
        if (differing != 0 && result_.differing_words == 0) {
            result_.first_difference = fmt::format(
                "sample {}, segment {}: RTL ds {} x {} y {} z {}, kernel ds {} x {} y {} z {} "
                "(fine words)",
                result_.samples, kernel_.segments() - 1, rtl.ds, rtl.fine[0], rtl.fine[1],
                rtl.fine[2], source_.ds(), fine[0], fine[1], fine[2]);
        }
        result_.differing_words += static_cast<std::uint64_t>(differing);
    }

    void compare_with_curve(const RtlSample<C>& rtl) {
        const ref::Segment& segment = cursor_.segment();
        const double s = cursor_.local();
        const ref::Vec3 curve = curve_.position(segment, s);
        ref::Vec3 point;
        double worst = 0;
        for (int axis = 0; axis < C::kAxes && axis < axes_; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double exact = axis < 3 ? curve[axis] : ref::exact_aux(segment, a - 3, s);
            const double fine = static_cast<double>(rtl.fine[axis]) * kFineUnit;
            if (axis < 3) point[axis] = fine;
            worst = std::max(worst, std::abs(fine - exact));
            result_.unrounded[a].add(fine - exact);
            result_.rounded[a].add(static_cast<double>(rtl.position[axis]) - exact);
        }
        KindResult& kind = kind_of(segment);
        ++kind.samples;
        kind.error = std::max(kind.error, worst);
        kind.bound = std::max(kind.bound, segment.bound);
        kind.of_bound = std::max(kind.of_bound, worst / segment.bound);
        pictures_.error(cursor_.s(), worst, segment.bound);
        pictures_.sample(cursor_.s(), cursor_.index(), point, cursor_.at_end());
        compare_speed(point, curve);
    }

    KindResult& kind_of(const ref::Segment& segment) {
        if (segment_of_kind_ != &segment) {
            segment_of_kind_ = &segment;
            kind_ = &result_.kinds[ref::kind_name(segment)];
        }
        return *kind_;
    }

    /// Chords between successive samples, before rounding, against those of the exact curve.
    void compare_speed(const ref::Vec3& point, const ref::Vec3& curve) {
        const ref::Vec3 chord = curve - last_curve_;
        const double length = chord.norm();
        if (length > 0) {
            const double error = std::abs((point - last_point_).norm() - length);
            KindResult& kind = kind_of(cursor_.segment());
            kind.speed_error = std::max(kind.speed_error, error);
            result_.speed_of_allowed =
                std::max(result_.speed_of_allowed, error / (1e-6 * length + chord_tolerance_));
            if (length >= kSpeedChord) {
                result_.speed_relative = std::max(result_.speed_relative, error / length);
            }
        }
        last_curve_ = curve;
        last_point_ = point;
    }

    bool stops(std::size_t segment) const {
        return segment + 1 == segments_.size() || job_.plan.segments[segment].feed_end < kRest;
    }

    /// The output word against the program's own end point.
    void compare_landing(const RtlSample<C>& rtl) {
        const ref::Move& move = job_.program.moves[cursor_.segment().move];
        for (int axis = 0; axis < C::kAxes && axis < axes_; ++axis) {
            const double end =
                axis < 3 ? move.end[axis] : move.aux_end[static_cast<std::size_t>(axis - 3)];
            const std::int64_t word = hls::to_position<C>(
                hls::quantise(end / job_.plan.unit_mm, C::kGuardBits, C::kFineBits));
            result_.landing = std::max(result_.landing, std::abs(rtl.position[axis] - word));
        }
        if (cursor_.index() != last_stop_) ++result_.stops;
        last_stop_ = cursor_.index();
    }

    const Job& job_;
    const std::vector<hls::SegmentWords<C>>& segments_;
    PathSource source_;
    hls::MotionKernel<C> kernel_;
    PathCursor cursor_;
    ref::CurveFollower curve_;
    SamplesWriter& samples_;
    Pictures& pictures_;
    int axes_;                // in use; the others stand at 0
    double chord_tolerance_;  // both ends off by the bound on every axis
    const ref::Segment* segment_of_kind_ = nullptr;
    KindResult* kind_ = nullptr;  // of that segment
    std::size_t next_segment_ = 0;
    std::size_t last_stop_ = static_cast<std::size_t>(-1);
    ref::Vec3 last_point_ = ref::Vec3::Zero();
    ref::Vec3 last_curve_ = ref::Vec3::Zero();
    CheckResult result_;
};

}  // namespace curvecore::tb
