// SPDX-License-Identifier: Apache-2.0
#include "tb/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hls/quantise.hpp"
#include "tb/compare/run_time_kernel.hpp"
#include "tb/program/check_result.hpp"

namespace curvecore::tb {
namespace {

constexpr std::int64_t kBatch = 8192;  // samples between two reports of progress

struct PositionCount {
    std::array<ErrorCount, kMostAxes> axis;
    ErrorCount along;
    ErrorCount across;

    void add(const double* error, const double* tangent, int axes) {
        double square = 0;
        double forward = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
            axis[i].add(error[i]);
            if (i >= 3) continue;
            square += error[i] * error[i];
            forward += error[i] * tangent[i];
        }
        along.add(forward);
        across.add(std::sqrt(std::max(0.0, square - forward * forward)));
    }

    PositionFigures figures(int axes) const {
        PositionFigures figures;
        for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
            figures.axis[i] = axis[i].figures();
        }
        figures.along = along.figures();
        figures.across = across.figures();
        return figures;
    }
};

class Comparison {
  public:
    Comparison(const Subject& subject, const Setting& setting, const Cut& cut, Row& row)
        : subject_(subject),
          cut_(cut),
          row_(row),
          guard_bits_(setting.format.guard_bits),
          unit_(std::ldexp(1.0, -guard_bits_)),
          axes_(3 + subject.program.aux_axes),
          segments_(words(setting)),
          kernel_(setting, segments_, axes_, row.ranges) {
        for (const ref::Segment& segment : cut.segments) {
            per_bound_.push_back(segment.bound > 0 ? 1 / segment.bound : 0);
        }
    }

    void run(const std::function<void(std::int64_t)>& progress) {
        const std::vector<ExactSample>& samples = subject_.exact.samples;
        std::int64_t reported = 0;
        std::size_t n = 0;
        for (std::size_t last = 0; last < cut_.segments.size(); ++last) {
            const ref::Segment& segment = cut_.segments[last];
            if (last + 1 < cut_.segments.size() && cut_.segments[last + 1].move == segment.move) {
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
    std::vector<RunSegment> words(const Setting& setting) const {
        std::vector<RunSegment> all;
        all.reserve(cut_.segments.size());
        for (const ref::Segment& segment : cut_.segments) {
            all.push_back(to_run_words(segment, setting.format, axes_));
        }
        return all;
    }

    void advance(std::int64_t s) {
        kernel_.sample(s - walked_, fine_);
        walked_ = s;
    }

    RunWord to_position(RunWord fine) const {
        return (fine + (RunWord(1) << (guard_bits_ - 1))) >> guard_bits_;
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
                         : subject_.exact.aux[n * static_cast<std::size_t>(axes_ - 3) + a - 3];
            const double fine = static_cast<double>(fine_[axis]) * unit_;
            if (axis < 3) point[a] = fine;
            before[a] = fine - there;
            after[a] = static_cast<double>(to_position(fine_[axis])) - there;
            worst = std::max(worst, std::abs(before[a]));
        }
        of_bound_ = std::max(of_bound_, worst * per_bound_[kernel_.segment()]);
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

    void land(const ref::Segment& segment, std::int64_t end) {
        advance(end);
        const ref::Move& move = subject_.program.moves[segment.move];
        for (int axis = 0; axis < axes_; ++axis) {
            const double place =
                axis < 3 ? move.end[axis] : move.aux_end[static_cast<std::size_t>(axis - 3)];
            const RunWord word = hls::quantise(place / subject_.unit_mm, guard_bits_, 62);
            row_.landing =
                std::max(row_.landing, std::abs(to_position(fine_[axis]) - to_position(word)));
        }
    }

    void finish() {
        row_.samples = subject_.exact.samples.size();
        row_.steps = kernel_.steps();
        row_.fine = fine_count_->figures(axes_);
        row_.output = output_count_->figures(axes_);
        row_.missing_bits = row_.ranges.missing();
        if (subject_.splines && !row_.setting.anchor) return;
        double bound = 0;
        for (const ref::Segment& segment : cut_.segments) bound = std::max(bound, segment.bound);
        row_.bound = bound;
        row_.of_bound = of_bound_;
    }

    const Subject& subject_;
    const Cut& cut_;
    Row& row_;
    const int guard_bits_;
    const double unit_;
    const int axes_;
    const std::vector<RunSegment> segments_;
    RunTimeKernel kernel_;
    std::vector<double> per_bound_;
    double of_bound_ = 0;
    std::int64_t walked_ = 0;
    RunWord fine_[kMostAxes] = {};
    double last_[3] = {};
    std::unique_ptr<PositionCount> fine_count_ = std::make_unique<PositionCount>();
    std::unique_ptr<PositionCount> output_count_ = std::make_unique<PositionCount>();
};

std::optional<CostEstimate> estimate_of(const Subject& subject, const Setting& setting) {
    if (subject.target.device == nullptr) return std::nullopt;
    CoreParameters parameters;
    parameters.build = subject.target.build;
    parameters.order = setting.format.order;
    parameters.coef_bits = setting.format.coef_bits;
    parameters.position_bits = setting.format.position_bits;
    parameters.guard_bits = setting.format.guard_bits;
    parameters.aux_axes = subject.program.aux_axes;
    parameters.splines = subject.splines ? 1 : 0;
    parameters.mode = setting.format.polynomial ? 1 : 0;
    parameters.sample_interval = subject.target.sample_interval;
    parameters.turn_bits = setting.format.turn_bits;
    parameters.parameter_guard = setting.format.parameter_guard;
    if ((parameters.turn_bits > 0 && !takes_turn_bits(parameters)) ||
        (parameters.parameter_guard > 0 && !takes_parameter_guard(parameters))) {
        return std::nullopt;
    }
    return estimate(core_for(subject.arcs, subject.splines, parameters.build), parameters,
                    *subject.target.device);
}

}  // namespace

double PositionFigures::worst() const {
    double worst = 0;
    for (const ErrorFigures& figures : axis) worst = std::max(worst, figures.worst);
    return worst;
}

Row compare_setting(const Subject& subject, const Setting& setting, const Cut& cut,
                    const std::function<void(std::int64_t)>& progress) {
    Row row;
    row.setting = setting;
    row.limit = cut.limit;
    row.refused = cut.refused;
    row.cost = multiplier_bits(setting, subject.arcs, subject.splines);
    row.estimate = estimate_of(subject, setting);
    row.ranges = ValueRanges(setting.format.coef_bits);
    row.segments = cut.segments.size();
    row.drawn = !cut.segments.empty();
    if (row.drawn) {
        Comparison(subject, setting, cut, row).run(progress);
    } else {
        progress(static_cast<std::int64_t>(subject.exact.samples.size()));
    }
    return row;
}

}  // namespace curvecore::tb
