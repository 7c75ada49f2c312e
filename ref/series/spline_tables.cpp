// SPDX-License-Identifier: Apache-2.0
#include "ref/series/spline_tables.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "ref/numeric/unlimited.hpp"
#include "ref/series/exact_path.hpp"

namespace curvecore::ref {
namespace {

namespace mp = boost::multiprecision;
using Precise = mp::number<mp::cpp_bin_float<40>, mp::et_off>;

constexpr double kDoubleShows = 1e-9;   // mm
constexpr double kShortestStep = 1e-4;  // mm

// Distance of the follower's point from r(u), and its phi |V| - 1 at its own u.
template <class Real>
struct Miss {
    double position;
    double feed;

    Miss(const Cubic& cubic, const SplineFollower<Real>& follower, const Real& exact_u) {
        using std::sqrt;
        const auto exact = spline_state(cubic, exact_u);
        const auto drawn = follower.position();
        Real square(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const Real miss = drawn[k] - exact[spline_node::kX + k];
            square += miss * miss;
        }
        position = static_cast<double>(sqrt(square));
        const auto& state = follower.state();
        const auto consistent = spline_state(cubic, state[spline_node::kU]);
        feed = static_cast<double>(state[spline_node::kPhi] / consistent[spline_node::kPhi] - 1);
    }

    bool lost() const { return !(position <= kSplineLostMm) || !std::isfinite(feed); }
};

// Stops as soon as the position is off by more than `enough`.
template <class Real>
Deviation follow_to(const Cubic& cubic, SplineMethod method, int order, double step,
                    double enough) {
    Deviation worst;
    for (int phase = 0; phase < kSplinePhases; ++phase) {
        ExactPath<Real> path(cubic);
        const Real h(step);
        const Real start = h * phase / kSplinePhases;
        SplineFollower<Real> follower(cubic, method, order, path.parameter(start));
        for (int n = 1; static_cast<double>(start + n * h) <= path.length(); ++n) {
            follower.step(h);
            const Miss<Real> miss(cubic, follower, path.parameter(start + n * h));
            worst.blow_up = worst.blow_up || miss.lost();
            worst.position = std::max(worst.position, miss.position);
            worst.feed = std::max(worst.feed, std::abs(miss.feed));
            if (worst.blow_up || worst.position > enough) {
                return worst;
            }
        }
    }
    return worst;
}

bool within_tolerance(const Cubic& cubic, SplineMethod method, int order, double step) {
    const Deviation found = follow_to<double>(cubic, method, order, step, kSplineToleranceMm);
    return !found.blow_up && found.position <= kSplineToleranceMm;
}

template <class Real>
Drift drift_in(const Cubic& cubic, SplineMethod method, double step) {
    const ArcLength table(cubic);
    SplineFollower<Real> follower(cubic, method, 8, Real(0));
    Drift found;
    found.steps = static_cast<long>(table.length() / step);
    const long every = std::max(found.steps / 100, 1L);
    for (long n = 1; n <= found.steps; ++n) {
        follower.step(static_cast<Real>(step));
        if (n % every == 0 || n == found.steps) {
            const auto drawn = follower.position();
            const Vec3 exact = cubic.position(table.parameter(static_cast<double>(n) * step));
            found.position =
                std::max(found.position, (Vec3(drawn[0], drawn[1], drawn[2]) - exact).norm());
        }
    }
    const auto& state = follower.state();
    found.phi = double(state[spline_node::kPhi]) * cubic.speed(state[spline_node::kU]) - 1;
    return found;
}

}  // namespace

Cubic hairpin(double radius, double depth) {
    // (c t, 4 depth t^2), t = u - 1/2
    const double c = std::sqrt(8 * depth * radius);
    return {Vec3::Zero(), Vec3(0, 4 * depth, 0), Vec3(c, -4 * depth, 0), Vec3(-c / 2, depth, 0)};
}

std::vector<TestSpline> test_splines() {
    const auto bezier = [](const Vec3& p1, const Vec3& p2, const Vec3& p3) {
        return from_bezier({Vec3::Zero(), p1, p2, p3});
    };
    return {
        {"gentle 2D", bezier({15, 0, 0}, {30, 10, 0}, {40, 20, 0})},
        {"gentle 3D", bezier({7, 1, 0}, {10, 5, 7}, {18, 2, 7})},
        {"corner", bezier({10, 0, 0}, {10, 0, 0}, {10, 10, 0})},
        {"hairpin 1", hairpin(1)},
        {"hairpin 0.3", hairpin(0.3)},
        {"near cusp 0.3", bezier({16, 20, 0}, {4, 20, 0}, {20, 0, 0})},
        {"hairpin 0.1", hairpin(0.1)},
        {"hairpin 0.03", hairpin(0.03)},
    };
}

Deviation follow(const Cubic& cubic, SplineMethod method, int order, double step) {
    const Deviation found = follow_to<double>(cubic, method, order, step, kUnlimited);
    if (found.blow_up || found.position > kDoubleShows) {
        return found;
    }
    return follow_to<Precise>(cubic, method, order, step, kUnlimited);
}

double largest_step(const Cubic& cubic, SplineMethod method, int order) {
    double good = 8;
    while (!within_tolerance(cubic, method, order, good)) {
        good /= 1.1;
        if (good < kShortestStep) {
            return 0;
        }
    }
    double bad = 1.1 * good;
    while (bad > 1.001 * good) {
        const double middle = std::sqrt(good * bad);
        (within_tolerance(cubic, method, order, middle) ? good : bad) = middle;
    }
    return good;
}

double vertex_error(double radius, double share, int order) {
    const Cubic cubic = hairpin(radius);
    const Precise h = boost::math::constants::quarter_pi<Precise>() * radius * share;
    ExactPath<Precise> path(cubic);
    const Precise vertex(path.length() / 2);
    const Precise u0 = path.parameter(vertex);
    SplineFollower<Precise> follower(cubic, SplineMethod::kPropagated, order, u0);
    follower.step(h);
    return Miss<Precise>(cubic, follower, path.parameter(vertex + h)).position;
}

Drift drift(const Cubic& cubic, SplineMethod method, double step, bool single_precision) {
    return single_precision ? drift_in<float>(cubic, method, step)
                            : drift_in<double>(cubic, method, step);
}

}  // namespace curvecore::ref
