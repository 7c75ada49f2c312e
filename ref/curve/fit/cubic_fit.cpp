// SPDX-License-Identifier: Apache-2.0
#include "ref/curve/fit/cubic_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "ref/curve/fit/hermite.hpp"

namespace curvecore::ref {
namespace {

constexpr int kChecked = 31;       // points at which a piece is measured
constexpr double kMargin = 1.1;    // the distance has lobes: 31 points miss less of their tops
constexpr int kSamples = 9;        // points at which the end speeds are fitted
constexpr int kMostSteps = 8;      // steps of the fit
constexpr int kMostHalvings = 60;  // halvings of the parameter
constexpr double kFlat = 1e-6;     // below, only the sum of the end speeds matters
constexpr double kRounding = 0x1p-46;

using Matrix = Eigen::Matrix<double, 3 * kSamples, 2>;
using Column = Eigen::Matrix<double, 3 * kSamples, 1>;

/// Moves t to the curve's point nearest to `point`, within t0 .. t1.
RationalBezier::Point nearest(const RationalBezier& curve, const Vec3& point, double t0, double t1,
                              double& t) {
    RationalBezier::Point here = curve.at(t);
    for (int i = 0; i < 3; ++i) {
        const double square = here.derivative.squaredNorm();
        if (!(square > 0)) break;
        const double next =
            std::clamp(t + (point - here.position).dot(here.derivative) / square, t0, t1);
        if (next == t) break;
        const RationalBezier::Point there = curve.at(next);
        if ((there.position - point).norm() >= (here.position - point).norm()) break;
        t = next;
        here = there;
    }
    return here;
}

struct Candidate {
    Cubic cubic;
    double distance;
};

class CubicFitter {
  public:
    CubicFitter(const RationalBezier& curve, double tolerance)
        : curve_(curve), tolerance_(tolerance) {
        for (const Eigen::Vector4d& point : curve.points) {
            const double size = (curve.origin + point.head<3>() / point[3]).norm();
            tolerance_ = std::max({tolerance_, kRounding * size, kRounding * curve.origin.norm()});
        }
    }

    std::vector<Cubic> run() {
        fit(0, 1, curve_.at(0), curve_.at(1), 0);
        return std::move(cubics_);
    }

  private:
    using End = RationalBezier::Point;

    void fit(double t0, double t1, const End& start, const End& end, int halvings) {
        HermitePiece piece;
        piece.start = start.position;
        piece.end = end.position;
        piece.start_d1 = (t1 - t0) * start.derivative;
        piece.end_d1 = (t1 - t0) * end.derivative;
        Candidate best = measured(piece, t0, t1);
        if (best.distance > tolerance_ && choose_speeds(piece, t0, t1)) {
            const Candidate other = measured(piece, t0, t1);
            if (other.distance < best.distance) best = other;
        }
        if (best.distance <= tolerance_ || halvings == kMostHalvings) {
            cubics_.push_back(best.cubic);
            return;
        }
        const double middle = t0 + (t1 - t0) / 2;
        const End half = curve_.at(middle);
        fit(t0, middle, start, half, halvings + 1);
        fit(middle, t1, half, end, halvings + 1);
    }

    Candidate measured(const HermitePiece& piece, double t0, double t1) const {
        const Cubic cubic = cubic_of_slopes(piece);
        return {cubic, kMargin * distance(cubic, curve_, t0, t1, kChecked)};
    }

    /// Fits the two end speeds by least squares of the distance (Gauss-Newton). Returns false if
    /// the curve has no direction at an end or the speeds run away.
    bool choose_speeds(HermitePiece& piece, double t0, double t1) const {
        const Eigen::Vector2d own(piece.start_d1.norm(), piece.end_d1.norm());
        if (!(own.minCoeff() > 1e-9 * own.maxCoeff())) return false;
        const Vec3 out = piece.start_d1 / own[0];
        const Vec3 in = piece.end_d1 / own[1];
        const double chord = (piece.end - piece.start).norm();
        Eigen::Vector2d speeds = own;
        std::array<double, kSamples> t{};
        for (int i = 0; i < kSamples; ++i) t[i] = t0 + (t1 - t0) * (i + 1) / (kSamples + 1);
        for (int step = 0; step < kMostSteps; ++step) {
            piece.start_d1 = speeds[0] * out;
            piece.end_d1 = speeds[1] * in;
            const Eigen::Vector2d change = correction(cubic_of_slopes(piece), out, in, t0, t1, t);
            speeds += change;
            if (!(speeds.minCoeff() > 0.1 * chord && speeds.maxCoeff() < 10 * chord)) return false;
            if (change.norm() < 1e-10 * chord) break;
        }
        piece.start_d1 = speeds[0] * out;
        piece.end_d1 = speeds[1] * in;
        return true;
    }

    Eigen::Vector2d correction(const Cubic& cubic, const Vec3& out, const Vec3& in, double t0,
                               double t1, std::array<double, kSamples>& t) const {
        Matrix slope;
        Column miss;
        for (int i = 0; i < kSamples; ++i) {
            const double u = static_cast<double>(i + 1) / (kSamples + 1);
            const Vec3 point = cubic.position(u);
            const End foot = nearest(curve_, point, t0, t1, t[i]);
            const Vec3 along = foot.derivative.stableNormalized();
            const auto across = [&along](const Vec3& v) { return Vec3(v - along * along.dot(v)); };
            slope.block<3, 1>(3 * i, 0) = across(u * (1 - u) * (1 - u) * out);
            slope.block<3, 1>(3 * i, 1) = across(-u * u * (1 - u) * in);
            miss.segment<3>(3 * i) = across(foot.position - point);
        }
        Eigen::CompleteOrthogonalDecomposition<Matrix> solver;
        solver.setThreshold(kFlat);
        return solver.compute(slope).solve(miss);
    }

    const RationalBezier& curve_;
    double tolerance_;
    std::vector<Cubic> cubics_;
};

}  // namespace

std::vector<Cubic> fit_cubics(const RationalBezier& curve, double tolerance) {
    return CubicFitter(curve, tolerance).run();
}

double distance(const Cubic& cubic, const RationalBezier& curve, double t0, double t1, int points) {
    double worst = 0;
    for (int i = 1; i <= points; ++i) {
        const double u = static_cast<double>(i) / (points + 1);
        double t = t0 + (t1 - t0) * u;
        const Vec3 point = cubic.position(u);
        worst = std::max(worst, (nearest(curve, point, t0, t1, t).position - point).norm());
    }
    return worst;
}

}  // namespace curvecore::ref
