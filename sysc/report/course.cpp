// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/course.hpp"

#include <algorithm>
#include <cmath>

#include "ref/plan/curve_follower.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::size_t kPlaces = 4 * Pictures::kBins;  // on the path, besides segments' ends

void add_outputs(const DrawnPlan& plan, Course& found) {
    if (plan.outputs.size() == 0) return;
    found.outputs.resize(Pictures::kBins);
    found.power.resize(Pictures::kBins);
    const auto bin_of = [&plan](std::uint64_t place) {
        const auto share = static_cast<double>(place) / static_cast<double>(plan.path_length());
        return std::min(static_cast<std::size_t>(share * Pictures::kBins), Pictures::kBins - 1);
    };
    int bits = 0;
    double power = 0;
    std::uint64_t from = 0;
    const auto fill = [&](std::uint64_t to) {
        for (std::size_t bin = bin_of(from); from < to && bin <= bin_of(to - 1); ++bin) {
            found.outputs[bin] |= bits;
            found.power[bin] = std::max(found.power[bin], power);
        }
        from = to;
    };
    for (std::size_t n = 0; n < plan.outputs.size(); ++n) {
        const ref::PlannedOutput output = plan.outputs[n];
        fill(output.place);
        if (output.kind == ref::OutputKind::kBits) bits = static_cast<int>(output.value);
        if (output.kind == ref::OutputKind::kLevel) power = output.value;
    }
    fill(plan.path_length());
}

}  // namespace

Course course(const Job& job) {
    const DrawnPlan& plan = job.plan;
    Course found;
    found.curvature.resize(Pictures::kBins);
    found.deviation.resize(Pictures::kBins);
    found.tolerance.resize(Pictures::kBins);
    for (std::vector<Envelope>& slope : found.slope) slope.resize(Pictures::kBins);
    const double total = std::ldexp(static_cast<double>(plan.path_length()), -16);
    ref::CurveFollower curve;
    for (std::size_t n = 0; n < plan.segments.size(); ++n) {
        const ref::Segment& segment = plan.segments[n];
        const double start = std::ldexp(static_cast<double>(segment.s_start), -16);
        const double length = std::ldexp(static_cast<double>(segment.length), -16);
        const ref::Move& move = plan.moves[segment.move];
        const double pieces = std::ceil(length / total * static_cast<double>(kPlaces));
        for (double i = 0; i <= pieces; ++i) {
            const double s = length * i / std::max(pieces, 1.0);
            const auto bin =
                std::min(static_cast<std::size_t>((start + s) / total * Pictures::kBins),
                         Pictures::kBins - 1);
            const double bend = curve.on(segment).curvature(s) / plan.unit_mm;
            const ref::Vec3 slope = curve.on(segment).direction(s);
            found.deviation[bin].add(move.deviation);
            if (move.deviation > 0) found.tolerance[bin].add(move.tolerance);
            if (std::isfinite(bend)) found.curvature[bin].add(bend);
            for (std::size_t axis = 0; axis < 3 && slope.allFinite(); ++axis) {
                found.slope[axis][bin].add(slope[static_cast<int>(axis)]);
            }
        }
    }
    add_outputs(plan, found);
    return found;
}

}  // namespace curvecore::sysc
