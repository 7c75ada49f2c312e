// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/table_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 9;
constexpr double kShortest = 1e-6;  // mm

struct Loads {
    double curvature = 0;
    double rate = 0;  // |r'''|
    double swerve = 0;
    Vec3 along = Vec3::Zero();

    void raise(const Loads& other) {
        curvature = std::max(curvature, other.curvature);
        rate = std::max(rate, other.rate);
        swerve = std::max(swerve, other.swerve);
        along = along.cwiseMax(other.along);
    }
};

class TableStretcher {
  public:
    TableStretcher(const Move& move, const TableCurve& curve, const Machine& machine)
        : move_(move), curve_(curve), machine_(machine) {}

    /// Stretches within one step.
    void stretch(double from, double to) {
        Loads found;
        double best = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const Loads here = at(from + (to - from) * i / (kPlaces - 1));
            found.raise(here);
            best = std::max(best, speed(here));
        }
        const Loads all = over(found, from, (to - from) / (kPlaces - 1) / 2);
        if (to - from <= kShortest || speed(all) >= kLeastShare * best) {
            stretches.push_back({from, to, shape(all, from, to)});
            return;
        }
        const double middle = (from + to) / 2;
        stretch(from, middle);
        stretch(middle, to);
    }

    std::vector<TableStretch> stretches;

  private:
    Loads at(double s) const {
        const Vec3 along = curve_.direction(s);
        const Vec3 bend = curve_.bend(s);
        const Vec3 rate = curve_.bend_rate(s);
        // r''' = -|r''|^2 r' + what is across
        return {bend.norm(), rate.norm(), (rate + bend.squaredNorm() * along).norm(),
                along.cwiseAbs()};
    }

    /// Bounds of what is no farther than `reach` from one of the places.
    Loads over(const Loads& found, double from, double reach) const {
        Loads all = found;
        const double fourth = curve_.most_derivative(from, 4);
        all.rate += fourth * reach;
        all.curvature += all.rate * reach;
        const double k = all.curvature;
        all.swerve += (fourth + 2 * k * all.rate + k * k * k) * reach;
        all.along = (all.along.array() + k * reach).cwiseMin(1.0);
        return all;
    }

    /// A stretch's shape without its ends.
    PathShape shape(const Loads& loads) const {
        PathShape shape;
        shape.turn = 1;
        shape.curvature = shape.twist = loads.curvature;
        shape.swerve = loads.swerve;
        for (int i = 0; i < 3; ++i) {
            const auto axis = static_cast<std::size_t>(i);
            shape.along[axis] = curve_.moves(i) ? loads.along[i] : 0;
            shape.swing[axis] = curve_.moves(i) ? 1 : 0;
        }
        return shape;
    }

    double speed(const Loads& loads) const {
        const double v = top_speed(shape(loads), machine_);
        return move_.rapid || move_.feed <= 0 ? v : std::min(v, move_.feed);
    }

    PathShape shape(const Loads& loads, double from, double to) const {
        PathShape of = shape(loads);
        of.length = to - from;
        const Vec3 first = curve_.direction(from);
        const Vec3 last = curve_.direction(to);
        for (int i = 0; i < 3; ++i) {
            of.tangent_start[static_cast<std::size_t>(i)] = first[i];
            of.tangent_end[static_cast<std::size_t>(i)] = last[i];
        }
        of.bend_start = curve_.bend(from);
        of.bend_end = curve_.bend(to);
        return of;
    }

    const Move& move_;
    const TableCurve& curve_;
    const Machine& machine_;
};

}  // namespace

std::vector<TableStretch> table_stretches(const Move& move, const TableCurve& curve,
                                          const Machine& machine, double from, double to) {
    TableStretcher stretcher(move, curve, machine);
    for (const double end : curve.step_ends()) {
        if (end <= from) continue;
        stretcher.stretch(from, std::min(end, to));
        from = std::min(end, to);
        if (from >= to) break;
    }
    return std::move(stretcher.stretches);
}

}  // namespace curvecore::ref
