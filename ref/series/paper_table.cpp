// SPDX-License-Identifier: Apache-2.0
#include "ref/series/paper_table.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "ref/series/figures.hpp"
#include "ref/series/interpreter.hpp"

namespace curvecore::ref {
namespace {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
using Spherical = NetworkInterpreter<Real, kSpherical.size(), 1>;

// State x, F, y, G, z, H on the plane with the normal B = (2, -2, 1) / 3.
Spherical::State start_state(const Real& radius) {
    const Real third = radius / 3;
    return {third, -2 * third, 2 * third, -third, 2 * third, 2 * third};
}

Real distance(const Spherical::State& a, const Spherical::State& b) {
    const Real x = a[0] - b[0];
    const Real y = a[2] - b[2];
    const Real z = a[4] - b[4];
    return sqrt(x * x + y * y + z * z);
}

PaperRow measure(int order, double feed_m_min) {
    const Real radius(kPaperRadiusMm);
    const Real tick = Real(feed_m_min) * 1000 / 60 / kPaperTicksPerSecond;  // mm
    const Spherical::State start = start_state(radius);
    Spherical network(kSpherical, order, {1 / radius});

    const Spherical::State first = network.step(start, tick);
    const Real c = cos(tick / radius);
    const Real s = sin(tick / radius);
    Spherical::State exact;
    for (std::size_t pair = 0; pair < start.size(); pair += 2) {
        exact[pair] = start[pair] * c + start[pair + 1] * s;
    }

    const Real circle = boost::math::constants::two_pi<Real>() * radius;
    const int ticks = static_cast<int>(circle / tick);
    Spherical::State state = first;
    for (int n = 1; n < ticks; ++n) {
        state = network.step(state, tick);
    }
    state = network.step(state, circle - ticks * tick);
    return {order, feed_m_min, static_cast<double>(distance(first, exact)),
            static_cast<double>(distance(state, start))};
}

struct Complex {
    Real real, imaginary;
};

Complex operator*(const Complex& a, const Complex& b) {
    return {a.real * b.real - a.imaginary * b.imaginary,
            a.real * b.imaginary + a.imaginary * b.real};
}

// The series of e^(i theta) up to the power `order`.
Complex turn(int order, const Real& theta) {
    Complex sum{1, 0};
    Complex term{1, 0};
    for (int k = 1; k <= order; ++k) {
        term = term * Complex{0, theta / k};
        sum = {sum.real + term.real, sum.imaginary + term.imaginary};
    }
    return sum;
}

Complex power(Complex base, long exponent) {
    Complex product{1, 0};
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) product = product * base;
        base = base * base;
    }
    return product;
}

Real theta_of(double feed_m_min, double tick_ms) {
    return Real(feed_m_min) / 60 * Real(tick_ms) / kPaperRadiusMm;
}

// Distance from the exact place after `ticks` ticks and a part of one.
double error_after(int order, const Real& theta, long ticks, const Real& part) {
    const Complex drawn = power(turn(order, theta), ticks) * turn(order, part);
    const Real angle = ticks * theta + part;
    const Real x = drawn.real - cos(angle);
    const Real y = drawn.imaginary - sin(angle);
    return kPaperRadiusMm * static_cast<double>(sqrt(x * x + y * y));
}

template <class Error>
int least_order(double tolerance, const Error& error) {
    int order = 1;
    while (error(order) > tolerance) ++order;
    return order;
}

}  // namespace

double circles_error(int order, double feed_m_min, double tick_ms, int circles) {
    const Real theta = theta_of(feed_m_min, tick_ms);
    const Real whole = circles * boost::math::constants::two_pi<Real>();
    const long ticks = static_cast<long>(whole / theta);
    return error_after(order, theta, ticks, whole - ticks * theta);
}

std::vector<OrderRow> minimal_orders() {
    std::vector<OrderRow> rows;
    for (const double tolerance : kOrderTolerancesMm) {
        for (const double tick : kOrderTicksMs) {
            const auto circles = [&](int count) {
                return least_order(tolerance, [&](int order) {
                    return circles_error(order, kOrdersFeed, tick, count);
                });
            };
            const Real theta = theta_of(kOrdersFeed, tick);
            const int step = least_order(
                tolerance, [&](int order) { return error_after(order, theta, 1, Real(0)); });
            rows.push_back({tick, tolerance, step, circles(1), circles(kManyCircles)});
        }
    }
    return rows;
}

std::vector<PaperRow> paper_table() {
    std::vector<PaperRow> rows;
    for (int order = 1; order <= kPaperOrders; ++order) {
        for (const double feed : kPaperFeedsMetresPerMinute) {
            rows.push_back(measure(order, feed));
        }
    }
    return rows;
}

}  // namespace curvecore::ref
