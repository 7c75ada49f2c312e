// SPDX-License-Identifier: Apache-2.0
// Cuts of a cubic are found once: they equal those found each time anew.
#include "ref/segment/spline_cut.hpp"

#include <gtest/gtest.h>

#include "sysc/curves/spline_families.hpp"

namespace curvecore::tb::spline_cut_test {
using namespace sysc;

const ref::CoreParameters kFormat{6, 36, 32, 10, true};
constexpr double kLimit = 0.1;
constexpr int kMost = 1 << 16;

void expect_same(const ref::SplineCut& found, const ref::SplineCut& wanted) {
    ASSERT_EQ(found.pieces.size(), wanted.pieces.size());
    EXPECT_EQ(found.lengths, wanted.lengths);
    for (std::size_t i = 0; i < found.pieces.size(); ++i) {
        const ref::Segment& piece = found.pieces[i];
        EXPECT_EQ(piece.start, wanted.pieces[i].start);
        EXPECT_EQ(piece.spline().c, wanted.pieces[i].spline().c);
        EXPECT_EQ(piece.bound, wanted.pieces[i].bound);
        EXPECT_EQ(piece.step_exponent, wanted.pieces[i].step_exponent);
        EXPECT_EQ(piece.aux_advance, wanted.pieces[i].aux_advance);
    }
}

TEST(KnownCuts, AreThoseOfTheCubicAndOfTheAuxiliaryAxes) {
    SplineMaker random(21);
    const ref::Cubic cubic = random.next(spline_families()[1]);
    ref::Cubic other = cubic;
    other.a.x() += 1;
    ref::KnownCuts known;
    for (int round = 0; round < 2; ++round) {
        for (const ref::Cubic& asked : {cubic, other}) {
            for (const ref::Aux& aux : {ref::Aux{}, ref::Aux{0.5}}) {
                expect_same(*known.of(asked, kFormat, kLimit, aux, kMost),
                            ref::cut_spline(asked, kFormat, kLimit, aux, kMost));
            }
        }
    }
}

TEST(KnownCuts, AreKeptForOneCoreAndLimit) {
    SplineMaker random(22);
    const ref::Cubic cubic = random.next(spline_families()[1]);
    ref::CoreParameters narrow = kFormat;
    narrow.coef_bits = 32;
    ref::KnownCuts known;
    const ref::SharedCut kept = known.of(cubic, kFormat, kLimit, {}, kMost);
    EXPECT_EQ(known.of(cubic, kFormat, kLimit, {}, kMost), kept);
    for (const double limit : {kLimit, 2 * kLimit}) {
        for (const ref::CoreParameters& format : {kFormat, narrow}) {
            expect_same(*known.of(cubic, format, limit, {}, kMost),
                        ref::cut_spline(cubic, format, limit, {}, kMost));
        }
    }
}

TEST(KnownCuts, ForgetsWhatWasAskedLongAgo) {
    ref::Cubic line;
    line.c = {1e5, 0, 0};
    ref::KnownCuts known;
    const auto cut = [&](int i) {
        line.d.x() = i;
        return known.of(line, kFormat, kLimit, {}, kMost);
    };
    ref::SharedCut last = cut(0);
    const ref::SharedCut mine = cut(-1);
    for (int i = 1; i < 20000; ++i) {
        last = cut(i);
        if (i % 4000 == 0) {
            EXPECT_EQ(cut(-1), mine);
        }
    }
    EXPECT_EQ(cut(19999), last);
    EXPECT_LE(known.size(), 10240U);
}

}  // namespace curvecore::tb::spline_cut_test
