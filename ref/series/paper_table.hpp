// SPDX-License-Identifier: Apache-2.0
// Measurement of the paper's claims about its spherical interpolator: error by order and feed.
#pragma once

#include <array>
#include <vector>

namespace curvecore::ref {

/// The paper's case: a circle of 50 mm diameter, one integration step per tick of 10 ms.
constexpr double kPaperRadiusMm = 25.0;
constexpr int kPaperTicksPerSecond = 100;
constexpr int kPaperOrders = 14;
constexpr std::array<double, 3> kPaperFeedsMetresPerMinute{1.5, 6.0, 60.0};

/// | field      | unit  | remark                                                              |
/// |------------|-------|---------------------------------------------------------------------|
/// | order      |       | P; 4 is the Runge-Kutta method of the paper (equal on this network) |
/// | feed_m_min | m/min |                                                                     |
/// | step_mm    | mm    | distance from the exact point after one tick                        |
/// | circle_mm  | mm    | the same after a full circle                                        |
///
/// A full circle is whole ticks and then one step of what remains of 2 pi R, so that the exact
/// point is the start. Laws: R h^(P+1)/(P+1)! and 2 pi R h^P/(P+1)!, h the angle of a tick.
struct PaperRow {
    int order;
    double feed_m_min;
    double step_mm;
    double circle_mm;
};

/// Rows in 100 decimal digits, by the network of Fig. 8 in a tilted plane; order by order, feeds
/// inside.
std::vector<PaperRow> paper_table();

/// | field        | unit | remark                                                    |
/// |--------------|------|-----------------------------------------------------------|
/// | tick_ms      | ms   | one integration step                                      |
/// | tolerance_mm | mm   |                                                           |
/// | step         |      | the least order that keeps it after one tick              |
/// | circle       |      | after a full circle                                       |
/// | circles      |      | after kManyCircles of them                                |
struct OrderRow {
    double tick_ms;
    double tolerance_mm;
    int step, circle, circles;
};
constexpr double kOrdersFeed = 60;  // m/min, on the same circle
constexpr std::array<double, 3> kOrderTicksMs{10, 1, 0.1};
constexpr std::array<double, 3> kOrderTolerancesMm{1e-3, 1e-6, 1e-9};
constexpr int kManyCircles = 1000;

/// Rows tolerance by tolerance, ticks inside. A step multiplies x + i F by the series of e^(i
/// theta) cut after its order, raised to the power of the ticks.
std::vector<OrderRow> minimal_orders();

/// Error after `circles` full circles, mm, as paper_table() has it for one.
double circles_error(int order, double feed_m_min, double tick_ms, int circles);

}  // namespace curvecore::ref
