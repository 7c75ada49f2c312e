// SPDX-License-Identifier: Apache-2.0
// A curve that no kernel draws, from its table alone: the machine against its integral in 50
// digits, its words within the table's bound.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "ref/bound/table_bound.hpp"
#include "ref/curves/table_machine.hpp"
#include "ref/curves/table_reader.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/kernel/table_words.hpp"

namespace curvecore::tb::clothoid_test {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

const ref::CurveTable& table() {
    static const ref::CurveTable kTable =
        ref::read_curve_table(std::string(CURVES_DIR) + "/clothoid.net");
    return kTable;
}

/// A segment: its frame at the start, the curvature of each axis, rad a step, so that another's
/// would be seen, and its change, rad a step and step. Of a clothoid the three are the same.
struct Clothoid {
    std::array<Real, 3> start;
    std::array<Real, 3> tangent;
    std::array<Real, 3> normal;
    std::array<Real, 3> kappa;
    Real sigma;
    int k = 0;  // a step is 2^k length units

    template <class Machine>
    void load(Machine& machine) const {
        for (int axis = 0; axis < 3; ++axis) {
            machine.set("T", tangent[axis], axis);
            machine.set("N", normal[axis], axis);
            machine.set("kappa", kappa[axis], axis);
        }
        machine.set("sigma", sigma);
        machine.load(start, k, k);
    }

    /// The same in words of a core.
    Clothoid in_words(const sysc::CoreParameters& core) const {
        const sysc::TableWords<Real> words{core.coef_bits, core.guard_bits};
        Clothoid made = *this;
        for (int axis = 0; axis < 3; ++axis) {
            made.start[axis] = words.position(start[axis]);
            made.tangent[axis] = words.rounded(tangent[axis], -2);
            made.normal[axis] = words.rounded(normal[axis], -2);
            made.kappa[axis] = words.rounded(kappa[axis], 1);
        }
        made.sigma = words.rounded(sigma, 1);
        return made;
    }

    /// The position after u steps: T turns by its curvature's integral.
    std::array<Real, 3> at(const Real& u) const {
        const boost::math::quadrature::gauss<Real, 30> gauss;
        std::array<Real, 3> place = start;
        for (int axis = 0; axis < 3; ++axis) {
            const auto turning = [&](const Real& v) {
                const Real turned = (kappa[axis] + sigma * v / 2) * v;
                return Real(cos(turned) * tangent[axis] + sin(turned) * normal[axis]);
            };
            for (int part = 0; part < u; ++part) {
                const Real end = std::min(u, Real(part + 1));
                place[axis] += ldexp(gauss.integrate(turning, Real(part), end), k);
            }
        }
        return place;
    }
};

/// A clothoid in a random plane, whose curvature stays below 1/8 in 8 steps.
Clothoid random_clothoid(const sysc::CoreParameters& core, std::mt19937_64& random) {
    const auto real = [&](double most) {
        return std::uniform_real_distribution<double>(-most, most)(random);
    };
    const Eigen::Vector3d t = Eigen::Vector3d(real(1), real(1), real(1)).normalized();
    const Eigen::Vector3d n = t.cross(Eigen::Vector3d(real(1), real(1), real(1))).normalized();
    Clothoid made;
    made.k = 8 + static_cast<int>(random() % static_cast<unsigned>(core.position_bits - 15));
    const double room = std::ldexp(1.0, core.position_bits - 2);
    for (int axis = 0; axis < 3; ++axis) {
        made.start[axis] = Real(real(room));
        made.tangent[axis] = Real(t[axis]);
        made.normal[axis] = Real(n[axis]);
        made.kappa[axis] = Real(real(1.0 / 16));
    }
    made.sigma = Real(real(1.0 / 128));
    return made;
}

TEST(Clothoid, OfTheTableIsTheIntegralOfItsTangent) {
    std::mt19937_64 random(3);
    ref::TableMachine<Real> machine(table(), 24, false);
    for (int n = 0; n < 6; ++n) {
        const Clothoid curve = random_clothoid({}, random);
        curve.load(machine);
        const Real length = ldexp(Real(1), curve.k);
        for (int step = 0; step < 4; ++step) {
            for (const double tau : {0.0, 0.37, 1.0}) {
                const auto drawn = machine.sample(Real(tau));
                const auto exact = curve.at(Real(step) + Real(tau));
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_LT(abs(drawn[axis] - exact[axis]), 1e-30 * length) << step << " " << tau;
                }
            }
            machine.step();
        }
    }
}

/// The bound's share that the worst sample of a curve in words reaches.
double share_of_bound(const sysc::CoreParameters& core, const Clothoid& curve,
                      std::mt19937_64& random) {
    constexpr int kSteps = 8;
    ref::TableSegment segment;
    segment.k = segment.lambda = curve.k;
    segment.steps = kSteps;
    const auto number = [](const Real& of) { return static_cast<double>(of); };
    for (int axis = 0; axis < 3; ++axis) {
        segment.values["T"][axis] = number(curve.tangent[axis]);
        segment.values["N"][axis] = number(curve.normal[axis]);
        segment.values["kappa"][axis] = number(curve.kappa[axis]);
    }
    segment.values["sigma"] = {number(curve.sigma), 0, 0};
    const ref::TableError bound = ref::table_error(table(), core, segment);
    EXPECT_TRUE(bound.beyond.empty());

    ref::TableMachine<Real, sysc::TableWords<Real>> words(table(), core.order, core.polynomial(),
                                                          {core.coef_bits, core.guard_bits});
    curve.in_words(core).load(words);
    double most = 0;
    for (int step = 0; step < kSteps; ++step) {
        if (step > 0) words.step();
        for (int sample = 0; sample < 3; ++sample) {
            const int unit = core.coef_bits - 1;
            const double path = std::uniform_real_distribution<double>(0, 1)(random);
            const auto at = words.sample(ldexp(floor(ldexp(Real(path), unit)), -unit));
            const auto exact = curve.at(Real(step) + Real(path));
            for (int axis = 0; axis < 3; ++axis) {
                const double error = number(abs(at[axis] - exact[axis]));
                const double of = bound.errors[static_cast<std::size_t>(step)][axis];
                EXPECT_LT(error, of) << "step " << step;
                most = std::max(most, error / of);
            }
        }
    }
    for (const auto& [row, largest] : bound.largest) {
        EXPECT_LE(number(words.largest(row)), largest) << row;
    }
    return most;
}

TEST(Clothoid, EverySampleInWordsIsWithinTheBoundOfItsTable) {
    std::mt19937_64 random(11);
    for (const int order : {2, 6, 12}) {
        for (const int bits : {24, 36}) {
            sysc::CoreParameters core;
            core.order = order;
            core.coef_bits = bits;
            double most = 0;
            for (int n = 0; n < 4; ++n) {
                most = std::max(most, share_of_bound(core, random_clothoid(core, random), random));
            }
            EXPECT_GT(most, 0.1) << "Order " << order << ", CoefBits " << bits;
        }
    }
}

}  // namespace curvecore::tb::clothoid_test
