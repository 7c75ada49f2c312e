// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/joint_shape.hpp"

#include <algorithm>
#include <cmath>

#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPlacesOfStretch = 5;
constexpr double kShortestStretch = 1e-3;  // mm

/// Largest magnitudes of the first three derivatives.
template <int Orders>
std::array<Vec3, 3> most_of(const VectorSeries<Orders>& series, double length) {
    return {series.most(length, 1), series.most(length, 2), series.most(length, 3)};
}

class JointStretcher {
  public:
    JointStretcher(const Move& move, const Machine& machine)
        : move_(move), machine_(machine), joints_(move.joints.joints), tool_(move.joints.tool) {}

    void stretch(double from, double to) {
        double best = 0;
        for (int i = 0; i < kPlacesOfStretch; ++i) {
            const double s = from + (to - from) * i / (kPlacesOfStretch - 1);
            best = std::max(best, speed(shape(s, s)));
        }
        PathShape all = shape(from, to);
        if (to - from > kShortestStretch && speed(all) < kLeastShare * best) {
            const double middle = (from + to) / 2;
            stretch(from, middle);
            stretch(middle, to);
            return;
        }
        set_ends(from, to, all);
        stretches.push_back({from, to, all});
    }

    std::vector<JointStretch> stretches;

  private:
    /// Bounds from one place to another, by the series from there on.
    PathShape shape(double from, double to) const {
        PathShape of;
        of.length = to - from;
        of.turn = 1;
        const auto joints = most_of(joints_.shifted(from), to - from);
        of.curvature = joints[1].maxCoeff();
        of.swerve = joints[2].maxCoeff();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            of.along[i] = joints[0][row];
            // along a + bend v^2 <= hypot(along, bend / curvature) hypot(a, v^2 curvature)
            const double bend = of.curvature > 0 ? joints[1][row] / of.curvature : 0;
            const double swerve = of.swerve > 0 ? joints[2][row] / of.swerve : 0;
            of.swing[i] = std::hypot(of.along[i], std::max(bend, swerve));
        }
        for (std::size_t i = 0; i < kAuxAxes; ++i) {
            of.advance[3 + i] = (move_.aux_end[i] - move_.aux_start[i]) / move_.joints.length;
            of.along[3 + i] = std::abs(of.advance[3 + i]);
        }
        const auto tool = most_of(tool_.shifted(from), to - from);
        of.linear = tool[0].maxCoeff() > 0;
        of.tool = ToolShape{};
        of.tool->rate = 1 / move_.joints.stretch;
        of.tool->curvature = tool[1].norm();
        // r''' of a circle is -|r''|^2 r' / |r'|^2; what is besides is at most this.
        of.tool->swerve = swerve_of(from, to, tool);
        return of;
    }

    /// Bound of |r''' + (|r''| / |r'|)^2 r'| of the tool: at the start, and what it may gain.
    double swerve_of(double from, double to, const std::array<Vec3, 3>& most) const {
        const Vec3 first = tool_.derivative(from, 1);
        const double square = first.squaredNorm();
        if (square == 0) return 0;
        const Vec3 second = tool_.derivative(from, 2);
        const Vec3 across = tool_.derivative(from, 3) + second.squaredNorm() / square * first;
        const double fourth = tool_.shifted(from).most(to - from, 4).norm();
        const double bend = most[1].norm();
        const double rate = std::sqrt(square);
        const double gain = fourth + (2 * bend * most[2].norm() + bend * bend * bend / rate) / rate;
        return across.norm() + gain * (to - from);
    }

    void set_ends(double from, double to, PathShape& of) const {
        of.tangent_start = of.tangent_end = of.advance;
        const Vec3 first = joints_.derivative(from, 1);
        const Vec3 last = joints_.derivative(to, 1);
        for (std::size_t i = 0; i < 3; ++i) {
            of.tangent_start[i] = first[static_cast<Eigen::Index>(i)];
            of.tangent_end[i] = last[static_cast<Eigen::Index>(i)];
        }
        of.bend_start = joints_.derivative(from, 2);
        of.bend_end = joints_.derivative(to, 2);
        of.tool->tangent_start = tool_.derivative(from, 1);
        of.tool->tangent_end = tool_.derivative(to, 1);
        of.tool->bend_start = tool_.derivative(from, 2);
        of.tool->bend_end = tool_.derivative(to, 2);
    }

    double speed(const PathShape& shape) const {
        const double v = top_speed(shape, machine_);
        return move_.rapid || move_.feed <= 0 ? v : std::min(v, move_.feed);
    }

    const Move& move_;
    const Machine& machine_;
    const VectorSeries<kJointOrders>& joints_;
    const VectorSeries<kToolOrders>& tool_;
};

}  // namespace

std::vector<JointStretch> joint_stretches(const Move& move, const Machine& machine) {
    JointStretcher stretcher(move, machine);
    stretcher.stretch(0, move.joints.length);
    return std::move(stretcher.stretches);
}

}  // namespace curvecore::ref
