// SPDX-License-Identifier: Apache-2.0
// Every table that programs may name: against its closed form, its words within their bound, and
// the engine's microcode against its words.
#include "tb/support/segments/table_families.hpp"

#include <gtest/gtest.h>

#include "hls/quantise.hpp"
#include "ref/curve/drawn/table_curve.hpp"
#include "ref/segment/table_segment.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"
#include "tb/support/microcode/table_comparison.hpp"

namespace curvecore::tb::table_families_test {

using ref::Vec3;

class TableFamily : public testing::TestWithParam<std::string> {
  protected:
    TableFamilies families_{CURVES_DIR, 1};
    std::mt19937_64 random_{7};
};

TEST_P(TableFamily, IsItsClosedForm) {
    for (int n = 0; n < cases(20, 500); ++n) {
        const TableCase exact = families_.next(GetParam());
        const ref::TableCurve curve(exact.piece, exact.at(0), exact.length);
        for (const double part : {0.0, 0.13, 0.5, 0.77, 1.0}) {
            const double s = part * exact.length;
            ASSERT_LT((curve.position(s) - exact.at(s)).norm(), 2e-12 * (200 + exact.length))
                << n << " " << part;
            ASSERT_NEAR(curve.direction(s).norm(), 1, 1e-12);
        }
    }
}

/// Segments as the planner cuts them, in words: every place is within their bound of the closed
/// form.
TEST_P(TableFamily, InWordsIsWithinItsBound) {
    constexpr double kUnit = 1e-6;  // mm
    ref::PlanOptions options;
    ref::add_table(families_.table(GetParam()), options.format);
    const sysc::RunTimeFormat format(options.format, 3);
    double most = 0;
    for (int n = 0; n < cases(1, 50); ++n) {
        const TableCase exact = families_.next(GetParam());
        const ref::TableCurve curve(exact.piece.rescaled(1 / kUnit), exact.at(0) / kUnit,
                                    exact.length / kUnit);
        double begin = 0;
        for (const ref::Segment& segment : ref::cut_table(curve, options)) {
            const sysc::RunSegment words = hls::to_words(segment, format);
            sysc::RunTimeKernel kernel(format);
            const auto length = static_cast<std::int64_t>(segment.length);
            std::int64_t at = 0;
            for (int sample = 0; sample < 20; ++sample) {
                const std::int64_t ds = (length - at) / (20 - sample) - 1;
                std::int64_t fine[sysc::kMostAxes];
                kernel.sample(
                    ds, [&] { return words; }, fine);
                at += ds;
                const double s = begin + std::ldexp(static_cast<double>(at), -16);
                const Vec3 place = exact.at(s * kUnit) / kUnit;
                for (int axis = 0; axis < 3; ++axis) {
                    const double drawn = std::ldexp(static_cast<double>(fine[axis]), -10);
                    // 1e-5: of the closed form in double precision
                    ASSERT_LT(std::abs(drawn - place[axis]), segment.bound + 1e-5) << n;
                    most = std::max(most, std::abs(drawn - place[axis]) / segment.bound);
                }
            }
            begin += std::ldexp(static_cast<double>(segment.length), -16);
        }
        ASSERT_NEAR(begin, exact.length / kUnit, 1);
    }
    EXPECT_GT(most, 0.05) << "of the bound";
}

TEST_P(TableFamily, IsDrawnByItsMicrocode) {
    int samples = 0;
    for (CurveCase of : configurations()) {
        if (of.spline || of.core.aux_axes > 0) continue;
        if (GetParam() == "quintic" && of.core.order > 6) continue;  // has no room in the engine
        ref::add_table(families_.table(GetParam()), of.core);
        MicrocodeOfTable microcode(of.core);
        const sysc::RunTimeFormat format(of.core, 3);
        for (int n = 0; n < 4; ++n) {
            ref::Segment segment;
            const TableCase exact = families_.next(GetParam());
            // Long steps, in which words keep their ranges
            const int k = of.core.position_bits - 7;
            const int parts = GetParam() == "archimedean" ? 9 : 6;
            const double unit = exact.length / std::ldexp(1, k + parts);
            segment.curve = exact.piece.rescaled(1 / unit);
            segment.step_exponent = k;
            EXPECT_EQ(microcode.draw(hls::to_words(segment, format), 4, random_), 0) << text(of);
        }
        EXPECT_FALSE(microcode.hazard()) << text(of);
        samples += microcode.samples();
    }
    EXPECT_GT(samples, 2000);
}

INSTANTIATE_TEST_SUITE_P(, TableFamily, testing::ValuesIn(TableFamilies::names()),
                         [](const auto& of) { return of.param; });

}  // namespace curvecore::tb::table_families_test
