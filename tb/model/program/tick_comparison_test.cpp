// SPDX-License-Identifier: Apache-2.0
// The schemes of `curvecore compare --scheme`, through its own code: they have the papers' figures,
// and our steps on the same curves stay within their bound.
#include "sysc/compare/tick_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ref/series/paper_words.hpp"
#include "ref/series/spline_tables.hpp"
#include "sysc/compare/compare_options.hpp"
#include "sysc/compare/sweep.hpp"

namespace curvecore::tb::tick_comparison_test {

using namespace sysc;

constexpr std::size_t kCurves = 8;     // of ref::test_splines()
constexpr double kSlow = 1500.0 / 60;  // mm/s
constexpr double kFast = 2000.0 / 60;
const std::vector<Scheme> kTicked{Scheme::kPaper, Scheme::kRungeKutta, Scheme::kScalar};

/// Rows of `--curves papers --scheme SCHEME ..`.
std::vector<Row> compare(const std::vector<Scheme>& schemes, const std::vector<double>& feeds,
                         const std::vector<std::string>& set = {}) {
    CompareOptions options;
    options.curves = CurveSet::kPapers;
    options.schemes = schemes;
    options.ticks = {10e-3};
    options.feeds = feeds;
    for (const std::string& one : set) options.set.push_back(read_parameter(one));
    options.sweep.samples = 2000;
    options.common.quiet = true;
    complete(options);
    const ref::Program program = built_in_curves(options.curves);
    check_ticked(program, options);
    complete_settings(program, options.drawn);
    return sweep(program, unlimited_machine(), options.drawn, options.sweep).rows;
}

/// The sixteen variables, one step a tick of 10 ms, mm, computed independently; 0: blows up. (The
/// gentle curve in space differs there: its figures are those of
/// scripts/results/spline_tick.md.)
TEST(TickComparison, RungeKuttaLosesWhatThePapersLose) {
    struct Feed {
        double feed;  // mm/s
        double expected[kCurves];
    };
    for (const Feed& test : {Feed{kSlow, {9.7e-10, 3.2e-7, 3.5e-5, 9.9e-3, 49, 0, 0, 0}},
                             Feed{kFast, {3.0e-9, 1.0e-6, 1.07e-4, 4.3e-2, 0, 0, 0, 0}}}) {
        const std::vector<Row> rows = compare({Scheme::kRungeKutta}, {test.feed});
        ASSERT_EQ(rows.size(), 1U);
        ASSERT_EQ(rows[0].by_move.size(), kCurves);
        for (std::size_t i = 0; i < kCurves; ++i) {
            EXPECT_EQ(std::isinf(rows[0].by_move[i]), test.expected[i] == 0) << i;
            if (test.expected[i] == 0) continue;
            EXPECT_NEAR(rows[0].by_move[i] / test.expected[i], 1, 0.07) << i;
        }
        EXPECT_FALSE(rows[0].has_figures());
        EXPECT_TRUE(rows[0].held()) << "a blow-up is a result";
    }
}

/// Values of scripts/results/spline_tick.md, by other code.
TEST(TickComparison, InDoubleIsWhatTheTablesFollow) {
    const std::vector<ref::TestSpline> curves = ref::test_splines();
    const double step = ref::tick_path(1.5, ref::kSplineTickMs);
    for (const Row& row : compare(kTicked, {kSlow}, {"Order=8"})) {
        if (row.ticks->words) continue;
        const ref::SplineMethod method =
            row.ticks->scheme == Scheme::kPaper    ? ref::SplineMethod::kPropagated
            : row.ticks->scheme == Scheme::kScalar ? ref::SplineMethod::kScalar
                                                   : ref::SplineMethod::kRungeKutta;
        for (std::size_t i = 0; i < kCurves; ++i) {
            const ref::Deviation found = ref::follow(curves[i].cubic, method, 8, step);
            EXPECT_EQ(std::isinf(row.by_move[i]), found.blow_up) << curves[i].name;
            if (found.blow_up || found.position < 1e-9) continue;
            EXPECT_NEAR(row.by_move[i] / found.position, 1, 1e-6) << curves[i].name;
        }
    }
}

TEST(TickComparison, OurStepsBesideThemStayWithinTheirBound) {
    const std::vector<Row> rows =
        compare({Scheme::kAnchored, Scheme::kPropagated, Scheme::kScalar}, {kSlow, kFast});
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_LE(rows[0].of_bound.value(), 1);
    EXPECT_FALSE(rows[1].bound.has_value());
    for (std::size_t i = 0; i < kCurves; ++i) {
        EXPECT_LT(rows[0].by_move[i], 1e-7);
        EXPECT_LT(rows[1].by_move[i], 1e-5);
    }
    // 000-4: one variable never diverges there.
    EXPECT_NEAR(rows[2].by_move[4], 3.3e-4, 0.1e-4);
    EXPECT_NEAR(rows[3].by_move[4], 1.3e-3, 0.05e-3);
    EXPECT_TRUE(rows[3].has_figures());
}

/// Words add their roundings, by their width, to the error in double.
TEST(TickComparison, ThePapersSchemeInWordsIsItsSeriesAndItsRoundings) {
    double last = 10;
    for (const int bits : {20, 28, 36}) {
        const std::vector<Row> rows =
            compare({Scheme::kPaper}, {kSlow}, {"CoefBits=" + std::to_string(bits)});
        ASSERT_EQ(rows.size(), 2U);
        ASSERT_TRUE(rows[0].ticks->words);
        const double gentle = rows[0].by_move[0];
        EXPECT_LT(gentle, last / 50) << bits;
        EXPECT_GT(gentle, std::ldexp(45.8, -bits)) << "no better than its words";
        last = gentle;
        EXPECT_NEAR(rows[1].by_move[2], 1.8e-7, 0.1e-7) << "in double no word counts";
        // The series dominates: a hairpin of 1 mm in 36 bits.
        if (bits == 36) {
            EXPECT_NEAR(rows[0].by_move[3] / rows[1].by_move[3], 1, 0.1);
        }
        EXPECT_EQ(rows[1].blow_ups, 4U) << bits;
    }
}

TEST(TickComparison, EachSchemeIsDrawnOnceForWhatItDependsOn) {
    const std::vector<std::string> set{"Order=4,6", "CoefBits=28,36", "GuardBits=8,10"};
    std::size_t words = 0;
    std::size_t in_double = 0;
    for (const Row& row : compare({Scheme::kPaper, Scheme::kRungeKutta}, {kFast}, set)) {
        if (!row.ticks->words) ++in_double;
        words += row.ticks->words ? 1 : 0;
    }
    EXPECT_EQ(words, 4U);
    EXPECT_EQ(in_double, 3U);
}

}  // namespace curvecore::tb::tick_comparison_test
