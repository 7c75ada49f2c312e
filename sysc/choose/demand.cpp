// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/demand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ref/curve/arc_length.hpp"
#include "ref/format/path_words.hpp"
#include "ref/geometry/arc_cover.hpp"
#include "ref/limits/limits.hpp"
#include "ref/limits/spline_shape.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kRangesPerOctave = 2;
constexpr double kShortSplines = 30;  // factor by which they are shorter than the longest

ref::Machine machine_of(const Requirement& requirement) {
    ref::Machine machine = requirement.machine;
    machine.velocity = requirement.feed;
    for (ref::AxisLimits& axis : machine.axis) axis.velocity = requirement.feed;
    return machine;
}

/// Greatest speed along an arc of this radius, mm, in any plane.
double arc_speed(const ref::Machine& machine, double radius) {
    ref::PathShape shape;
    shape.length = radius;
    shape.turn = 1;
    shape.twist = 1 / radius;
    shape.curvature = 1 / radius;
    for (std::size_t i = 0; i < 3; ++i) shape.swing[i] = 1;
    return ref::top_speed(shape, machine);
}

}  // namespace

double Demand::segments() const { return std::max(arcs.segments, splines.segments); }

double Demand::bound() const { return std::max(arcs.bound, splines.bound); }

double DemandModel::Curve::time(double path) const {
    const auto end = std::lower_bound(paths.begin(), paths.end(), path);
    if (end == paths.end()) return times.back();
    const auto i = static_cast<std::size_t>(end - paths.begin());
    const double from = i > 0 ? paths[i - 1] : 0;
    const double start = i > 0 ? times[i - 1] : 0;
    return start + (times[i] - start) * (path - from) / (paths[i] - from);
}

DemandModel::DemandModel(const Requirement& requirement) : requirement_(requirement) {
    if (!requirement.splines()) return;
    // A straight line at full feed comes first: little work, and soon refused.
    for (const double length : {requirement.length_mm / kShortSplines, requirement.length_mm}) {
        SplineMaker maker(1);
        for (const SplineShape shape :
             {SplineShape::kStraight, SplineShape::kRandom, SplineShape::kSBend,
              SplineShape::kInflexion, SplineShape::kHairpin, SplineShape::kNearCusp}) {
            add_curve(maker.next({"", shape, 1e6}), length);
        }
    }
}

void DemandModel::add_curve(const ref::Cubic& shape, double length) {
    const double scale = length / ref::ArcLength(shape).length();
    ref::Move move;
    move.kind = ref::Move::Kind::kCubic;
    move.feed = requirement_.feed;
    move.cubic = {shape.a * scale, shape.b * scale, shape.c * scale, ref::Vec3::Zero()};
    move.start = move.cubic.position(0);
    move.end = move.cubic.position(1);
    const ref::Machine machine = machine_of(requirement_);
    const ref::ArcLength arc(move.cubic);
    Curve curve{move.cubic, arc.length(), {}, {}};
    double time = 0;
    double path = 0;
    for (const ref::SplineStretch& stretch : ref::spline_stretches(move, arc, machine, 0, 1)) {
        const double end = arc.path(stretch.u1);
        time += (end - path) / std::min(requirement_.feed, ref::top_speed(stretch.shape, machine));
        path = end;
        curve.paths.push_back(path);
        curve.times.push_back(time);
    }
    curves_.push_back(std::move(curve));
}

Demand DemandModel::demand(const CoreParameters& format, double unit_mm, double limit,
                           const Load& most) const {
    Demand demand;
    if (requirement_.arcs()) demand.arcs = arc_load(format, unit_mm, limit, most);
    if (requirement_.splines() && demand.arcs.within(most)) {
        demand.splines = spline_load(format, unit_mm, limit, most);
    }
    return demand;
}

Load DemandModel::arc_load(const CoreParameters& format, double unit_mm, double limit,
                           const Load& most) const {
    const ref::Machine machine = machine_of(requirement_);
    const double ratio = std::exp2(1.0 / kRangesPerOctave);
    Load load;
    for (double high = requirement_.radius_mm;
         high > requirement_.least_radius_mm || load.segments == 0; high /= ratio) {
        const double low = std::max(high / ratio, std::min(requirement_.least_radius_mm, high));
        const ref::ArcCover proof = ref::arc_cover(format, low / unit_mm, high / unit_mm, limit);
        if (proof.longest == 0) {
            load.drawable = false;
            return load;
        }
        load.bound = std::max(load.bound, proof.bound);
        // The planner's bound for one radius is a little lower: its pieces may be longer.
        const double speed = arc_speed(machine, high) / unit_mm;
        const ref::ArcCover own = ref::arc_cover(format, high / unit_mm, high / unit_mm, limit);
        for (const ref::ArcCover& cover : {proof, own}) {
            load.segments = std::max(load.segments, speed / cover.shortest);
            load.steps = std::max(load.steps, speed * cover.steps_per_unit);
        }
        if (!load.within(most)) return load;
    }
    return load;
}

Load DemandModel::spline_load(const CoreParameters& format, double unit_mm, double limit,
                              const Load& most) const {
    Load load;
    for (const Curve& curve : curves_) {
        const double seconds = curve.times.back();
        const double pieces = std::min(65536.0, most.segments * seconds + 1);
        const ref::Cubic& mm = curve.cubic;
        long double path = 0;
        std::vector<ref::Segment> segments;
        try {
            segments =
                ref::split_spline({mm.a / unit_mm, mm.b / unit_mm, mm.c / unit_mm, mm.d / unit_mm},
                                  format, limit, path, {}, static_cast<int>(pieces));
        } catch (const std::domain_error&) {
            load.drawable = limit >= 2 * std::ldexp(1.0, -format.guard_bits);
            load.segments = std::numeric_limits<double>::infinity();
            return load;
        }
        load.segments = std::max(load.segments, static_cast<double>(segments.size()) / seconds);
        for (const ref::Segment& segment : segments) {
            load.bound = std::max(load.bound, segment.bound);
            if (segment.length == 0) continue;
            const double from =
                static_cast<double>(segment.s_start) / ref::kQuantaPerUnit * unit_mm;
            const double units = static_cast<double>(segment.length) / ref::kQuantaPerUnit;
            const double span = curve.time(from + units * unit_mm) - curve.time(from);
            const double steps = std::ceil(std::ldexp(units, -segment.step_exponent));
            load.steps = std::max(load.steps, steps / span);
        }
        if (!load.within(most)) return load;
    }
    return load;
}

}  // namespace curvecore::sysc
