// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/spline_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/curve/vector_polynomial.hpp"
#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSharpestRadius = 1e-8;  // mm, radius of a tip that is passed in motion
constexpr double kShortestLength = 1e-6;  // mm
// Values that no machine feels at any speed below 10 m/s.
constexpr double kNoCurvature = 1e-9;  // 1/mm
constexpr double kNoSwerve = 1e-12;    // 1/mm^2

struct Bounds {
    double curvature = 0;
    double swerve = 0;
    Vec3 swing = Vec3::Zero();
    Vec3 along = Vec3::Ones();
};

/// The polynomials of the header.
class Frenet {
  public:
    explicit Frenet(const Cubic& p) {
        v_ << p.c, 2 * p.b, 3 * p.a;
        Vectors<2> w;
        w << 2 * p.b, 6 * p.a;
        m_ << 2 * p.c.cross(p.b), 6 * p.c.cross(p.a), 6 * p.b.cross(p.a);
        Vectors<2> slope;
        slope << m_.col(1), 2 * m_.col(2);
        g_ = scaled<5, 2>(dot<3, 3>(v_, v_), slope) - scaled<4, 3>(3 * dot<3, 2>(v_, w), m_);
    }

    /// Bounds at the point u.
    Bounds at(double u) const {
        const double v = value(v_, u).norm();
        const double cube = v * v * v;
        return felt({value(m_, u).norm() / cube, value(g_, u).norm() / (cube * cube), Vec3::Ones(),
                     value(v_, u).cwiseAbs() / v});
    }

    /// Bounds where the speed is at least v.
    Bounds over(double v) const {
        const double cube = v * v * v;
        Bounds bounds = felt({longest(m_) / cube, longest(g_) / (cube * cube), Vec3::Zero()});
        Vec3 across = Vec3::Zero();
        if (bounds.curvature > 0) {
            across = widest(cross<3, 3>(m_, v_)) / (cube * v * bounds.curvature);
        }
        if (bounds.swerve > 0) {
            across =
                across.cwiseMax(widest(cross<6, 3>(g_, v_)) / (cube * cube * v * bounds.swerve));
        }
        const Vec3 along = widest(v_) / v;
        bounds.swing = (along.cwiseAbs2() + across.cwiseAbs2()).cwiseSqrt().cwiseMin(1.0);
        bounds.along = along.cwiseMin(1.0);
        return bounds;
    }

  private:
    static Bounds felt(Bounds bounds) {
        if (bounds.curvature < kNoCurvature) bounds.curvature = 0;
        if (bounds.swerve < kNoSwerve) bounds.swerve = 0;
        return bounds;
    }

    Vectors<3> v_;
    Vectors<3> m_;
    Vectors<6> g_;
};

/// Returns true if the curve stands still, also where W = 0, judged by how fast |V| grows.
bool stands_still(const Cubic& cubic, double u) {
    const double v = cubic.speed(u);
    return v * v <= kSharpestRadius * cubic.acceleration(u).norm() ||
           v * v * v <= kSharpestRadius * kSharpestRadius * cubic.jerk().norm();
}

class SplineStretcher {
  public:
    SplineStretcher(const Move& move, const ArcLength& arc, const Machine& machine)
        : move_(move), arc_(arc), machine_(machine) {}

    void stretch(double u0, double u1) {
        const Cubic part = sub_cubic(move_.cubic, u0, u1);
        const SpeedRange speed = speed_range(part);
        const double length = arc_.path(u1) - arc_.path(u0);
        const Frenet frenet(part);
        const bool still = stands_still(part, speed.at_min);
        Bounds bounds;
        if (still && length <= kTipLength) {
            bounds = frenet.at(speed.at_max);
            bounds.along = Vec3::Ones();
        } else if (!still) {
            bounds = frenet.over(speed.min);
        }
        const bool known = !still || length <= kTipLength;
        if (known && (still || length <= kShortestLength || wide_enough(frenet, bounds))) {
            stretches.push_back({u0, u1, shape(bounds, u0, u1, length)});
            return;
        }
        const double middle = (u0 + u1) / 2;
        stretch(u0, middle);
        stretch(middle, u1);
    }

    std::vector<SplineStretch> stretches;

  private:
    double speed(const Bounds& bounds) const {
        PathShape shape;
        shape.turn = 1;
        shape.curvature = shape.twist = bounds.curvature;
        shape.swerve = bounds.swerve;
        for (int i = 0; i < 3; ++i) {
            shape.swing[static_cast<std::size_t>(i)] = bounds.swing[i];
            shape.along[static_cast<std::size_t>(i)] = bounds.along[i];
        }
        const double v = top_speed(shape, machine_);
        return move_.rapid || move_.feed <= 0 ? v : std::min(v, move_.feed);
    }

    bool wide_enough(const Frenet& frenet, const Bounds& bounds) const {
        const double here = speed(bounds);
        double best = 0;
        for (int i = 0; i <= 4; ++i) {
            Bounds point = frenet.at(i / 4.0);
            point.swing = bounds.swing;
            best = std::max(best, speed(point));
        }
        return here >= kLeastShare * best;
    }

    PathShape shape(const Bounds& bounds, double u0, double u1, double length) const {
        PathShape shape;
        shape.length = length;
        shape.turn = 1;
        shape.curvature = shape.twist = bounds.curvature;
        shape.swerve = bounds.swerve;
        const Cubic& cubic = move_.cubic;
        const bool starts = !stands_still(cubic, u0);
        const bool ends = !stands_still(cubic, u1);
        for (int i = 0; i < 3; ++i) {
            const auto axis = static_cast<std::size_t>(i);
            const bool moves = cubic.a[i] != 0 || cubic.b[i] != 0 || cubic.c[i] != 0;
            shape.swing[axis] = moves ? bounds.swing[i] : 0;
            shape.along[axis] = moves ? bounds.along[i] : 0;
            if (starts) shape.tangent_start[axis] = tangent(cubic, u0)[i];
            if (ends) shape.tangent_end[axis] = tangent(cubic, u1)[i];
        }
        if (starts) shape.bend_start = curvature_vector(cubic, u0);
        if (ends) shape.bend_end = curvature_vector(cubic, u1);
        for (std::size_t i = 0; i < kAuxAxes; ++i) {
            const double rate = (move_.aux_end[i] - move_.aux_start[i]) / arc_.length();
            shape.advance[3 + i] = shape.tangent_start[3 + i] = shape.tangent_end[3 + i] = rate;
            shape.along[3 + i] = std::abs(rate);
        }
        return shape;
    }

    const Move& move_;
    const ArcLength& arc_;
    const Machine& machine_;
};

}  // namespace

std::vector<double> standstills(const Cubic& cubic) {
    // A standstill all but at an end is the end's.
    bool first = stands_still(cubic, 0);
    bool last = stands_still(cubic, 1);
    std::vector<double> stops;
    for (const double u : speed_extrema(cubic)) {
        if (!stands_still(cubic, u)) continue;
        const bool near_start = arc_length(cubic, 0, u) < kTipLength;
        const bool near_end = arc_length(cubic, u, 1) < kTipLength;
        first = first || near_start;
        last = last || near_end;
        const bool apart = stops.empty() || arc_length(cubic, stops.back(), u) >= kTipLength;
        if (!near_start && !near_end && apart) stops.push_back(u);
    }
    if (first) stops.insert(stops.begin(), 0.0);
    if (last) stops.push_back(1.0);
    return stops;
}

std::vector<SplineStretch> spline_stretches(const Move& move, const ArcLength& arc,
                                            const Machine& machine, double u0, double u1) {
    SplineStretcher stretcher(move, arc, machine);
    stretcher.stretch(u0, u1);
    return std::move(stretcher.stretches);
}

}  // namespace curvecore::ref
