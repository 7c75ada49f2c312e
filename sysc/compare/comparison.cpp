// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hls/quantise.hpp"
#include "sysc/kernel/run_time_kernel.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::int64_t kBatch = 8192;  // samples between two reports of progress

class Comparison {
  public:
    Comparison(const Subject& subject, const CoreParameters& setting,
               const SegmentedProgram& segmented, Row& row)
        : subject_(subject),
          segmented_(segmented),
          row_(row),
          unit_(std::ldexp(1.0, -setting.guard_bits)),
          axes_(3 + subject.program.aux_axes),
          format_(setting, axes_, &row.ranges),
          segments_(words()),
          kernel_(format_) {
        for (const ref::Segment& segment : segmented.segments) {
            per_bound_.push_back(segment.bound > 0 ? 1 / segment.bound : 0);
        }
        if (subject.by_move) row.by_move.assign(subject.program.moves.size(), 0);
    }

    void run(const std::function<void(std::int64_t)>& progress) {
        const std::vector<ExactSample>& samples = subject_.exact.samples;
        std::int64_t reported = 0;
        std::size_t n = 0;
        for (std::size_t last = 0; last < segmented_.segments.size(); ++last) {
            const ref::Segment& segment = segmented_.segments[last];
            if (last + 1 < segmented_.segments.size() &&
                segmented_.segments[last + 1].move == segment.move) {
                continue;
            }
            const auto end = static_cast<std::int64_t>(segment.s_start + segment.length);
            for (; n < samples.size() && samples[n].s < end; ++n) {
                sample(n);
                if (static_cast<std::int64_t>(n) - reported == kBatch) {
                    progress(kBatch);
                    reported = static_cast<std::int64_t>(n);
                }
            }
            land(segment, end);
        }
        progress(static_cast<std::int64_t>(samples.size()) - reported);
        finish();
    }

  private:
    std::vector<RunSegment> words() const {
        std::vector<RunSegment> all;
        all.reserve(segmented_.segments.size());
        for (const ref::Segment& segment : segmented_.segments) {
            all.push_back(hls::to_words(segment, format_));
        }
        return all;
    }

    void advance(std::int64_t s) {
        kernel_.sample(
            s - walked_, [this]() -> const RunSegment& { return segments_.at(next_++); }, fine_);
        walked_ = s;
    }

    void sample(std::size_t n) {
        const ExactSample& exact = subject_.exact.samples[n];
        advance(exact.s);
        double before[kMostAxes];
        double after[kMostAxes];
        double point[3];
        double worst = 0;
        for (int axis = 0; axis < axes_; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double there =
                axis < 3 ? exact.position[a]
                         : subject_.exact.aux[n * static_cast<std::size_t>(axes_ - 3) + a - 3] -
                               segmented_.segments[next_ - 1].aux_turned[a - 3];
            const double fine = static_cast<double>(fine_[axis]) * unit_;
            if (axis < 3) point[a] = fine;
            before[a] = fine - there;
            after[a] = static_cast<double>(hls::to_position(fine_[axis], format_)) - there;
            worst = std::max(worst, std::abs(before[a]));
        }
        of_bound_ = std::max(of_bound_, worst * per_bound_[next_ - 1]);
        if (subject_.by_move) {
            double& most = row_.by_move[segmented_.segments[next_ - 1].move];
            most = std::max(most, std::hypot(before[0], before[1], before[2]) * subject_.unit_mm);
        }
        fine_count_->add(before, exact.tangent, axes_);
        output_count_->add(after, exact.tangent, axes_);
        if (exact.chord > 0) {
            const double x = point[0] - last_[0];
            const double y = point[1] - last_[1];
            const double z = point[2] - last_[2];
            const double error = std::abs(std::sqrt(x * x + y * y + z * z) - exact.chord);
            row_.speed_error = std::max(row_.speed_error, error);
            if (exact.chord >= kSpeedChord) {
                row_.speed_relative =
                    std::max(row_.speed_relative.value_or(0), error / exact.chord);
            }
        }
        std::copy(point, point + 3, last_);
    }

    void land(const ref::Segment& segment, std::int64_t s) {
        advance(s);
        const ref::Move& move = subject_.program.moves[segment.move];
        for (int axis = 0; axis < axes_; ++axis) {
            const double place =
                axis < 3 ? move.end[axis] : move.aux_end[static_cast<std::size_t>(axis - 3)];
            const double turned =
                axis < 3 ? 0 : segment.aux_turned[static_cast<std::size_t>(axis - 3)];
            const std::int64_t end =
                hls::quantise(place / subject_.unit_mm - turned, format_.kGuardBits, 62);
            row_.landing = std::max(row_.landing, std::abs(hls::to_position(fine_[axis], format_) -
                                                           hls::to_position(end, format_)));
        }
    }

    void finish() {
        row_.samples = subject_.exact.samples.size();
        row_.steps = static_cast<std::uint64_t>(kernel_.steps());
        row_.fine = fine_count_->figures(axes_);
        row_.output = output_count_->figures(axes_);
        row_.missing_bits = row_.ranges.missing();
        if (subject_.splines && row_.setting.anchor == 0) return;
        double bound = 0;
        for (const ref::Segment& segment : segmented_.segments)
            bound = std::max(bound, segment.bound);
        row_.bound = bound;
        row_.of_bound = of_bound_;
    }

    const Subject& subject_;
    const SegmentedProgram& segmented_;
    Row& row_;
    const double unit_;
    const int axes_;
    const RunTimeFormat format_;
    const std::vector<RunSegment> segments_;
    RunTimeKernel kernel_;
    std::size_t next_ = 0;  // segment after the present one
    std::vector<double> per_bound_;
    double of_bound_ = 0;
    std::int64_t walked_ = 0;
    std::int64_t fine_[kMostAxes] = {};
    double last_[3] = {};
    std::unique_ptr<PositionCount> fine_count_ = std::make_unique<PositionCount>();
    std::unique_ptr<PositionCount> output_count_ = std::make_unique<PositionCount>();
};

}  // namespace

Row compare_setting(const Subject& subject, const CoreParameters& setting,
                    const SegmentedProgram& segmented,
                    const std::function<void(std::int64_t)>& progress) {
    Row row;
    row.setting = setting;
    row.limit = segmented.limit;
    row.refused = segmented.refused;
    row.cost = multiplier_bits(setting, subject.arcs, subject.splines);
    if (subject.device != nullptr) {
        row.estimate = estimate(core_for(subject.arcs, subject.splines, setting.build), setting,
                                *subject.device);
    }
    row.ranges = ValueRanges(setting.coef_bits);
    row.segments = segmented.segments.size();
    row.drawn = !segmented.segments.empty();
    if (row.drawn) {
        Comparison(subject, setting, segmented, row).run(progress);
    } else {
        progress(static_cast<std::int64_t>(subject.exact.samples.size()));
    }
    return row;
}

}  // namespace curvecore::sysc
