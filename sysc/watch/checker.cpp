// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "hls/quantise.hpp"
#include "ref/curve/axes.hpp"
#include "sysc/curves/error_figures.hpp"

namespace curvecore::sysc {
Checker::Checker(const Job& job, SamplesWriter& samples, Pictures& pictures)
    : job_(job),
      core_axes_(job.options.core.axes()),
      axes_(std::min(core_axes_, 3 + job.plan.aux_axes)),
      fine_unit_(std::ldexp(1.0, -job.options.core.guard_bits)),
      chord_tolerance_(std::max(0.1, 2 * std::sqrt(3.0) * job.bound())),
      source_(job.plan, job.options.samples_per_tick_log2(), job.options.override_word()),
      format_(job.options.core, core_axes_),
      kernel_(format_),
      words_(format_),
      cursor_(job.plan),
      samples_(samples),
      pictures_(pictures),
      drawn_(job.machine, job.plan.unit_mm, job.options.sample_period_s,
             job.options.samples_per_tick, axes_),
      rounded_(job.machine, job.plan.unit_mm, job.options.sample_period_s,
               job.options.samples_per_tick, axes_, 0.5 + job.bound()) {
    if (ToolMeter::is_asked(job.machine)) {
        tool_.emplace(job.machine, job.plan.unit_mm, job.options.sample_period_s,
                      job.options.samples_per_tick, axes_);
    }
    pictures.watch(drawn_);
    start();
}

const CheckResult& Checker::result() {
    result_.drawn = drawn_.finish();
    result_.rounded_limits = rounded_.finish();
    if (tool_) result_.tool = tool_->finish();
    return result_;
}

void Checker::take(const Sample& drawn) {
    ++result_.samples;
    const bool tick = source_.next();
    compare_with_kernel(drawn);
    const double share =
        std::ldexp(static_cast<double>(source_.tick_ds()), -job_.options.samples_per_tick_log2());
    result_.increment =
        std::max(result_.increment, std::abs(static_cast<double>(drawn.ds) - share));
    cursor_.advance(static_cast<std::uint64_t>(drawn.ds));
    if (tick) pictures_.tick(source_.tick_ds());
    compare_with_curve(drawn);
    if (cursor_.at_end() && stops(cursor_.index())) compare_landing(drawn);
    samples_.row(result_.samples, cursor_.index(), cursor_.s(), drawn.position.data());
}

/// Takes the start words as the sample before the first request.
void Checker::start() {
    const RunSegment first = hls::to_words(cursor_.segment(), format_);
    std::int64_t position[kMostAxes];
    for (int axis = 0; axis < core_axes_; ++axis) {
        position[axis] = hls::to_position(first.start[axis], format_);
        if (axis < 3) last_point_[axis] = static_cast<double>(first.start[axis]) * fine_unit_;
    }
    const ref::Segment& segment = cursor_.segment();
    last_curve_ = segment.start;
    meter(ref::exact_point(segment, segment.start, 0), position);
    samples_.row(0, cursor_.index(), 0, position);
    pictures_.sample(0, cursor_.index(), compare_tool(last_curve_, turned(0), 0), true);
}

void Checker::compare_with_kernel(const Sample& drawn) {
    std::int64_t fine[kMostAxes];
    kernel_.sample(
        source_.ds(), [this] { return words_.next(job_.plan.segments[next_segment_++]); }, fine);
    int differing = (drawn.ds != source_.ds()) + (drawn.rate != source_.rate());
    for (int axis = 0; axis < core_axes_; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        differing += drawn.fine[a] != fine[axis];
        differing += drawn.position[a] != hls::to_position(fine[axis], format_);
    }
    if (differing != 0 && result_.differing_words == 0) {
        result_.first_difference =
            fmt::format("sample {}, segment {} of line {}: {}", result_.samples, next_segment_ - 1,
                        job_.plan.segments[next_segment_ - 1].line, differences(drawn, fine));
    }
    result_.differing_words += static_cast<std::uint64_t>(differing);
}

/// Names the words of a sample that are not the kernel's.
std::string Checker::differences(const Sample& drawn, const std::int64_t* fine) const {
    std::string board = "board";
    std::string kernel = "kernel";
    const auto compare = [&](const std::string& name, std::int64_t of_board, std::int64_t wanted) {
        if (of_board == wanted) return;
        board += fmt::format(" {} {}", name, of_board);
        kernel += fmt::format(" {} {}", name, wanted);
    };
    compare("ds", drawn.ds, source_.ds());
    compare("rate", drawn.rate, source_.rate());
    for (int axis = 0; axis < core_axes_; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const std::string name(1, static_cast<char>(std::tolower(ref::kAxisLetters[a])));
        compare("fine " + name, drawn.fine[a], fine[axis]);
        compare(name, drawn.position[a], hls::to_position(fine[axis], format_));
    }
    return board + ", " + kernel;
}

void Checker::compare_with_curve(const Sample& drawn) {
    const ref::Segment& segment = cursor_.segment();
    const double s = cursor_.local();
    const ref::Vec3 curve = curve_.on(segment).position(s);
    ref::Vec3 point;
    ref::Vec3 abc = turned(s);
    double worst = 0;
    for (int axis = 0; axis < axes_; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double exact = axis < 3 ? curve[axis] : ref::exact_aux(segment, a - 3, s);
        const double fine = static_cast<double>(drawn.fine[a]) * fine_unit_;
        if (axis < 3) point[axis] = fine;
        if (axis >= 3 && axis < 6) abc[axis - 3] += fine - exact;
        worst = std::max(worst, std::abs(fine - exact));
        result_.unrounded[a].add(fine - exact);
        result_.rounded[a].add(static_cast<double>(drawn.position[a]) - exact);
    }
    KindResult& kind = kind_of(segment);
    ++kind.samples;
    kind.error = std::max(kind.error, worst);
    const double bound = job_.bounded(segment.kind()) ? segment.bound : 0;
    if (bound > 0) {
        kind.bound = std::max(kind.bound, bound);
        kind.of_bound = std::max(kind.of_bound, worst / bound);
    }
    meter(ref::exact_point(segment, curve, s), drawn.position.data());
    pictures_.error(cursor_.s(), worst, bound);
    pictures_.sample(cursor_.s(), cursor_.index(), compare_tool(point, abc, s), cursor_.at_end());
    compare_speed(point, curve);
}

void Checker::meter(const ref::AxisPoint& exact, const std::int64_t* position) {
    drawn_.take(exact, cursor_.index());
    if (tool_) tool_->take(exact, cursor_.index());
    ref::AxisPoint rounded{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(axes_); ++i) {
        rounded[i] = static_cast<double>(position[i]);
        if (i >= 3) rounded[i] += cursor_.segment().aux_turned[i - 3];
    }
    rounded_.take(rounded, cursor_.index());
}

/// A B C of the exact plan, with all their turns, units.
ref::Vec3 Checker::turned(double s) const {
    const ref::AxisPoint at = ref::exact_point(cursor_.segment(), ref::Vec3::Zero(), s);
    return {at[3], at[4], at[5]};
}

/// Compares the tool of drawn joints and A B C, before rounding, in units, with its path; returns
/// its place.
ref::Vec3 Checker::compare_tool(const ref::Vec3& joints, const ref::Vec3& abc, double s) {
    const ref::Kinematics& kinematics = job_.machine.kinematics;
    if (ref::is_trivial(kinematics)) return joints;
    const double unit = job_.plan.unit_mm;
    const ref::Segment& segment = cursor_.segment();
    const ref::Move& move = job_.plan.moves[segment.move];
    const ref::Vec3 tool = ref::tool_of(kinematics, joints * unit, abc * unit);
    if (move.kind == ref::Move::Kind::kJoints) {
        const double off = (tool - move.joints.tool.at(s * unit)).norm();
        const double of_bound =
            off / ref::tool_error(kinematics, joints * unit, abc * unit, segment.bound * unit);
        // What is not a number stays.
        if (!(off <= result_.tool_off)) result_.tool_off = off;
        if (!(of_bound <= result_.tool_of_bound)) result_.tool_of_bound = of_bound;
    }
    return tool / unit;
}

KindResult& Checker::kind_of(const ref::Segment& segment) {
    if (segment_of_kind_ != &segment) {
        segment_of_kind_ = &segment;
        kind_ = &result_.kinds[segment.kind_name()];
    }
    return *kind_;
}

/// Compares chords between successive samples, before rounding, with those of the exact curve.
void Checker::compare_speed(const ref::Vec3& point, const ref::Vec3& curve) {
    const ref::Vec3 chord = curve - last_curve_;
    const double length = chord.norm();
    if (length > 0) {
        const double error = std::abs((point - last_point_).norm() - length);
        KindResult& kind = kind_of(cursor_.segment());
        kind.speed_error = std::max(kind.speed_error, error);
        if (job_.bounded(cursor_.segment().kind())) {
            result_.speed_of_allowed =
                std::max(result_.speed_of_allowed, error / (1e-6 * length + chord_tolerance_));
        }
        if (length >= kSpeedChord) {
            result_.speed_relative = std::max(result_.speed_relative, error / length);
        }
    }
    last_curve_ = curve;
    last_point_ = point;
}

bool Checker::stops(std::size_t segment) const {
    return segment + 1 == job_.plan.segments.size() || ends_at_rest(job_.plan.segments[segment]);
}

/// Compares the output word with the program's own end point.
void Checker::compare_landing(const Sample& drawn) {
    const ref::Move& move = job_.plan.moves[cursor_.segment().move];
    for (int axis = 0; axis < axes_; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double end = (axis < 3 ? move.end[axis] : move.aux_end[a - 3]) / job_.plan.unit_mm;
        const double turned = axis < 3 ? 0 : cursor_.segment().aux_turned[a - 3];
        const std::int64_t fine =
            hls::quantise(end - turned, format_.kGuardBits, format_.kFineBits);
        const std::int64_t word = hls::to_position(fine, format_);
        result_.landing = std::max(result_.landing, std::abs(drawn.position[a] - word));
    }
    if (cursor_.index() != last_stop_) ++result_.stops;
    last_stop_ = cursor_.index();
}

}  // namespace curvecore::sysc
