// SPDX-License-Identifier: Apache-2.0
// The bound that comes from a table's lines beside the one that is derived by hand, and beside the
// samples of the table in words.
#include "ref/bound/table_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "ref/bound/error_tape.hpp"
#include "ref/curves/table_machine.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/feed/planner.hpp"
#include "ref/format/path_words.hpp"
#include "ref/plan/segment_curve.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"
#include "sysc/kernel/table_words.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::table_bound_test {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<113, mp::digit_base_2>, mp::et_off>;

double uniform(std::mt19937_64& random) { return std::generate_canonical<double, 53>(random); }

std::array<double, 3> axes(const ref::Vec3& of) { return {of[0], of[1], of[2]}; }

ref::TableSegment rows_of(const ref::SplinePiece& spline, int /*k*/) {
    ref::TableSegment made;
    made.values = {{"a", axes(spline.a)},
                   {"b", axes(spline.b)},
                   {"c", axes(spline.c)},
                   {"phi", {1 / spline.c.norm(), 0, 0}}};
    made.lambda = spline.lambda;
    return made;
}
ref::TableSegment rows_of(const ref::ArcPiece& arc, int k) {
    ref::TableSegment made;
    made.values = {{"theta", {std::ldexp(arc.twist(), k), 0, 0}},
                   {"t", axes(arc.tangent * arc.cos_pitch)},
                   {"n", axes(arc.normal * arc.cos_pitch)},
                   {"advance", axes(arc.advance)}};
    made.lambda = k;
    return made;
}
ref::TableSegment rows_of(const ref::TablePiece& piece, int k) {
    ref::TableSegment made;
    made.values = piece.rows(std::ldexp(1.0, k));
    made.lambda = k;
    return made;
}

/// The segment as the table of its kind draws it.
ref::TableSegment rows_of(const ref::Segment& segment) {
    ref::TableSegment made = std::visit(
        [&](const auto& curve) { return rows_of(curve, segment.step_exponent); }, segment.curve);
    made.k = segment.step_exponent;
    const double steps = std::ldexp(static_cast<double>(segment.length), -ref::kPathFrac - made.k);
    made.steps = static_cast<int>(std::ceil(steps));
    made.last = steps - (made.steps - 1);
    return made;
}

/// Draws a segment in words; returns the share of the bound that its worst sample reaches.
double share_of_bound(const ref::CurveTable& table, const ref::CoreParameters& core,
                      const ref::Segment& segment, const ref::TableError& bound,
                      std::mt19937_64& random) {
    const ref::TableSegment rows = rows_of(segment);
    const sysc::TableWords<Real> words{core.coef_bits, core.guard_bits};
    ref::TableMachine<Real, sysc::TableWords<Real>> machine(table, core.order, core.polynomial(),
                                                            words);
    for (const auto& [row, values] : rows.values) {
        for (int axis = 0; axis < 3; ++axis) {
            const int fraction = table.rows.at(row).fraction;
            machine.set(row, words.rounded(Real(values[axis]), fraction), axis);
        }
    }
    const auto start = [&](int axis) { return words.position(Real(segment.start[axis])); };
    machine.load({start(0), start(1), start(2)}, rows.k, rows.lambda);
    double most = 0;
    for (int step = 0; step < rows.steps; ++step) {
        if (step > 0) machine.step();
        for (int sample = 0; sample < 6; ++sample) {
            const double part = step + 1 < rows.steps ? 1 : rows.last;
            const int unit = core.coef_bits - 1;
            const double quanta = std::floor(std::ldexp(part * uniform(random), rows.k + 16));
            const double tau = std::ldexp(quanta, -rows.k - 16);
            const auto at = machine.sample(ldexp(floor(ldexp(Real(tau), unit)), -unit));
            const double s = std::ldexp(step + tau, rows.k);
            const ref::Vec3 exact = ref::exact_position(segment, s);
            for (int axis = 0; axis < 3; ++axis) {
                const auto error = static_cast<double>(abs(at[axis] - Real(exact[axis])));
                const double of = bound.errors[static_cast<std::size_t>(step)][axis];
                EXPECT_LT(error, of) << "step " << step;
                most = std::max(most, error / of);
            }
        }
    }
    return most;
}

// Each source of an error alone: samples of whole segments would hide one that is missing.
TEST(TableBound, HasEverySourceOfAnError) {
    ref::ErrorTape tape;
    const ref::TracedWords words{10, 4, &tape};
    const auto own = [&](const ref::TracedNumber& of) {
        return tape.own(static_cast<std::size_t>(of.node));
    };
    const ref::TracedNumber third = words.weight(3);
    EXPECT_DOUBLE_EQ(third.error, 171.0 / 512 - 1.0 / 3);
    EXPECT_EQ(own(third), third.error);
    EXPECT_EQ(words.weight(4).error, 0);

    const ref::TracedNumber a(0.5, 0.01, 8, &tape, tape.add(0.01));
    const ref::TracedNumber b(0.25, 0.02, 8, &tape, tape.add(0.02));
    const ref::TracedNumber product = a * b;
    EXPECT_DOUBLE_EQ(own(product), 0.01 * 0.02);
    EXPECT_DOUBLE_EQ(product.error, 0.5 * 0.02 + 0.25 * 0.01 + 0.01 * 0.02);
    const ref::TracedNumber rounded = words.rounded(product, -2);
    EXPECT_EQ(own(rounded), std::ldexp(0.5, -8));
    EXPECT_DOUBLE_EQ(rounded.error, product.error + std::ldexp(0.5, -8));
    EXPECT_EQ(own(words.position(product)), std::ldexp(0.5, -4));
    EXPECT_EQ(words.rounded(a, -2).node, a.node) << "a word of as many bits is not rounded";

    const ref::TracedNumber sum = ldexp(rounded, 3) + a;
    const Eigen::MatrixXd partials = tape.sweep({sum.node});
    EXPECT_EQ(partials(a.node, 0), 8 * 0.25 + 1);
    EXPECT_EQ(partials(b.node, 0), 8 * 0.5);
    EXPECT_EQ(partials(rounded.node, 0), 8);
    EXPECT_EQ(partials(third.node, 0), 0);
}

/// Segments' bounds by the table and by hand, and the worst sample of each.
class BoundComparison {
  public:
    BoundComparison(const char* table, int mode)
        : table_(ref::read_curve_table(std::string(CURVES_DIR) + "/" + table)) {
        core_.mode = mode;
    }

    void add(const ref::Segment& segment) {
        const ref::TableError bound = ref::table_error(table_, core_, rows_of(segment));
        EXPECT_TRUE(bound.beyond.empty()) << bound.beyond.front();
        ratios_.push_back(bound.worst() / segment.bound);
        shares_.push_back(share_of_bound(table_, core_, segment, bound, random_));
    }

    /// Checks that no bound is idle, nor far above the one by hand.
    void check() {
        std::sort(ratios_.begin(), ratios_.end());
        ASSERT_GT(ratios_.size(), 10U);
        EXPECT_GT(ratios_.front(), 0.4) << "an error may be missing";
        EXPECT_LT(ratios_.back(), 1.1);
        EXPECT_LT(ratios_[ratios_.size() / 2], 1);
        EXPECT_GT(*std::min_element(shares_.begin(), shares_.end()), 0.15);
    }

    const ref::CoreParameters& core() const { return core_; }

  private:
    ref::CurveTable table_;
    ref::CoreParameters core_;
    std::mt19937_64 random_{9};
    std::vector<double> ratios_;
    std::vector<double> shares_;
};

TEST(TableBound, OfSplinesHoldsAndIsAsTightAsTheOneByHand) {
    for (const int mode : {0, 1}) {
        BoundComparison comparison("spline.net", mode);
        sysc::SplineMaker random(5);
        for (const sysc::SplineFamily& family : sysc::spline_families()) {
            const auto all = ref::split_spline(random.next(family), comparison.core(), 0.1);
            const ref::Segment& segment = all[all.size() / 2];
            if (segment.kind() == ref::CurveKind::kSpline) comparison.add(segment);
        }
        comparison.check();
    }
}

TEST(TableBound, OfArcsHoldsAndIsAsTightAsTheOneByHand) {
    for (const int mode : {0, 1}) {
        BoundComparison comparison("arc.net", mode);
        ref::PlanOptions options;
        options.format = comparison.core();
        std::mt19937_64 random(3);
        for (double radius = 0.01; radius < 500; radius *= 2) {
            ProgramBuilder builder;
            const ref::Vec3 normal(uniform(random), uniform(random), 0.1);
            const ref::Vec3 arm = normal.cross(ref::Vec3::UnitX()).normalized() * radius;
            builder.line(arm, 100);
            builder.arc({0, 0, 0}, normal.normalized(), 0.1 + uniform(random),
                        radius * uniform(random), 100);
            comparison.add(make_plan(builder.program(), {}, options).segments.back());
        }
        comparison.check();
    }
}

}  // namespace curvecore::tb::table_bound_test
