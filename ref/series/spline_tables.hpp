// SPDX-License-Identifier: Apache-2.0
// Measurement of the paper's claims about a spline's sixteen variables.
#pragma once

#include <string>
#include <vector>

#include "ref/curve/cubic.hpp"
#include "ref/series/spline_methods.hpp"

namespace curvecore::ref {

// The paper's case: one integration step per tick of 10 ms, at feeds of 1.5 and 2 m/min.
constexpr double kSplineTickMs = 10;
constexpr double kSplineFeedsMetresPerMinute[] = {1.5, 2.0};
constexpr double kSplineToleranceMm = 1e-3;

// Criteria for every method: this many phases of the first tick, and this distance off the curve.
constexpr int kSplinePhases = 5;
constexpr double kSplineLostMm = 1000;

/// Path of a tick in mm: 1 m/min is 1 / 60 mm per ms.
constexpr double tick_path(double feed_m_min, double tick_ms) { return feed_m_min / 60 * tick_ms; }

/// | name      | length mm | least radius mm | speed ratio |                                      |
/// |-----------|-----------|-----------------|-------------|--------------------------------------|
/// | gentle 2D |      45.8 |            33.8 |         1.1 |                                      |
/// | gentle 3D |      20.2 |            9.44 |         1.3 |                                      |
/// | corner    |      18.0 |            2.65 |         2.8 | 90 degrees                           |
/// | hairpin r |      > 40 |               r | 6.4 .. 115  | parabola, 20 mm deep                 |
/// | near cusp |      36.2 |             0.3 |        12.8 | handles that cross                   |
struct TestSpline {
    std::string name;
    Cubic cubic;
};
Cubic hairpin(double radius, double depth = 20);
std::vector<TestSpline> test_splines();

/// Largest deviations over the whole curve and five phases of the first tick.
///
/// | field    | unit | remark                                                              |
/// |----------|------|---------------------------------------------------------------------|
/// | position | mm   | distance of the drawn point from the exact one of the same path     |
/// | feed     | 1    | phi |V| - 1, the relative error of the path speed                   |
/// | blow_up  |      | a value became infinite or the point left the curve by > 1000 mm    |
struct Deviation {
    double position = 0;
    double feed = 0;
    bool blow_up = false;
};

/// Draws a spline from one end to the other in steps of `step` mm: in double, and again in 40
/// digits where double's roundings would show, below 1e-9 mm.
Deviation follow(const Cubic& cubic, SplineMethod method, int order, double step);

/// Returns the largest step in mm that keeps every position within kSplineToleranceMm: the first
/// that does on a falling scale of factors 1.1, then bisected to 0.1 %; 0 if none does down to 1e-4
/// mm. Divided by the feed it is the longest period of an interrupt.
double largest_step(const Cubic& cubic, SplineMethod method, int order);

/// Returns the local error, mm, of one step from the vertex of hairpin(radius), in 40 digits; the
/// step is `share` of the radius of convergence pi/4 radius.
double vertex_error(double radius, double share, int order);

/// Drift over hundreds of thousands of short steps without interruption, order 8, at the curve's
/// end.
///
/// | field    | unit | remark                                       |
/// |----------|------|----------------------------------------------|
/// | steps    |      |                                              |
/// | position | mm   | as above, largest of 100 points on the way   |
/// | phi      | 1    | phi |V| - 1 at the end, with its sign        |
struct Drift {
    long steps = 0;
    double position = 0;
    double phi = 0;
};
Drift drift(const Cubic& cubic, SplineMethod method, double step, bool single_precision = false);

}  // namespace curvecore::ref
