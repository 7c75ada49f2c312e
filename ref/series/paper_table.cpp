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
using Spherical = Interpreter<Real, kSpherical.size(), 1>;

// x, F, y, G, z, H on the plane with the normal B = (2, -2, 1) / 3.
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

}  // namespace

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
