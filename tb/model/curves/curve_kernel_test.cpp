// SPDX-License-Identifier: Apache-2.0
// Kernels of C++ that are made of tables (hls/curves) against the table run in words; those of arcs
// and splines: table_machine_test.cpp.
#include <gtest/gtest.h>

#include "hls/curves/arc.hpp"
#include "hls/curves/archimedean.hpp"
#include "hls/curves/catenary.hpp"
#include "hls/curves/clothoid.hpp"
#include "hls/curves/ellipse.hpp"
#include "hls/curves/involute.hpp"
#include "hls/curves/kernel_text.hpp"
#include "hls/curves/quintic.hpp"
#include "hls/curves/series.hpp"
#include "hls/curves/spiral.hpp"
#include "hls/curves/spline.hpp"
#include "hls/quantise.hpp"
#include "ref/text/input_error.hpp"
#include "shapes.hpp"
#include "sysc/kernel/table_kernel.hpp"
#include "tb/support/microcode/curve_comparison.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/segments/table_families.hpp"

namespace curvecore::tb::curve_kernel_test {

using Format = sysc::RunTimeFormat;

/// Samples of so many axes that differ, over steps of a segment.
template <class Kernel, class Other>
int differ(Kernel& kernel, Other& other, const sysc::RunSegment& words, int axes, int steps,
           std::mt19937_64& random) {
    kernel.load(words);
    other.load(words);
    int sum = 0;
    for (int step = 0; step < steps; ++step) {
        if (step > 0) {
            kernel.step();
            other.step();
        }
        for (int sample = 0; sample < 3; ++sample) {
            const int bits = words.step_exponent + hls::kPathFrac;
            const auto sigma =
                static_cast<std::int64_t>(sample == 0 ? 0 : random() % (std::uint64_t{1} << bits));
            std::int64_t fine[sysc::kMostAxes];
            std::int64_t others[sysc::kMostAxes];
            kernel.sample(sigma, fine);
            other.sample(sigma, others);
            for (int axis = 0; axis < axes; ++axis) sum += fine[axis] == others[axis] ? 0 : 1;
        }
    }
    return sum;
}

template <class Kernel>
void draws_the_tables_words(const std::string& name) {
    TableFamilies families(CURVES_DIR, 3);
    std::mt19937_64 random(9);
    const auto table = families.table(name);
    EXPECT_EQ(Kernel::kFurther, table->further_words());
    for (CurveCase of : configurations()) {
        if (of.spline) continue;
        ref::add_table(table, of.core);
        const Format format(of.core, of.core.axes());
        Kernel kernel(format);
        sysc::TableKernel machine(*table, format);
        for (int n = 0; n < cases(2, 50); ++n) {
            ref::Segment segment;
            const TableCase exact = families.next(name);
            const int k = of.core.position_bits - 7;  // long steps, in which words keep ranges
            const int parts = name == "archimedean" ? 9 : 6;
            segment.curve = exact.piece.rescaled(std::ldexp(1, k + parts) / exact.length);
            segment.step_exponent = k;
            EXPECT_EQ(differ(kernel, machine, hls::to_words(segment, format), 3, 3, random), 0)
                << name << " " << text(of);
        }
    }
}

TEST(CurveKernel, OfATableHasItsWords) {
    draws_the_tables_words<hls::ArchimedeanCurve<Format>>("archimedean");
    draws_the_tables_words<hls::CatenaryCurve<Format>>("catenary");
    draws_the_tables_words<hls::ClothoidCurve<Format>>("clothoid");
    draws_the_tables_words<hls::EllipseCurve<Format>>("ellipse");
    draws_the_tables_words<hls::InvoluteCurve<Format>>("involute");
    draws_the_tables_words<hls::QuinticCurve<Format>>("quintic");
    draws_the_tables_words<hls::SpiralCurve<Format>>("spiral");
}

TEST(CurveKernel, OfASeriesHasItsWords) {
    const ref::CurveTable table = ref::read_curve_table(std::string(CURVES_DIR) + "/series.net");
    std::mt19937_64 random(2);
    for (CurveCase of : configurations()) {
        if (of.spline) continue;
        ref::add_table(std::make_shared<ref::CurveTable>(table), of.core);
        const Format format(of.core, of.core.axes());
        hls::SeriesCurve<Format> kernel(format);
        sysc::TableKernel machine(table, format);
        for (int n = 0; n < cases(5, 200); ++n) {
            const auto word = [&](int order) {
                const double most = std::ldexp(1.0, of.core.coef_bits - 3 - order);
                return static_cast<std::int64_t>(
                    std::uniform_real_distribution<double>(-most, most)(random));
            };
            sysc::RunSegment words;
            words.step_exponent = std::min(hls::kMaxStepExponent, of.core.position_bits - 4);
            words.lambda = words.step_exponent;
            for (int axis = 0; axis < 3; ++axis) {
                words.tangent[axis] = word(0);
                words.normal[axis] = word(1);
                words.advance[axis] = word(2);
                for (int order = 3; order < 6; ++order) {
                    words.further[3 * (order - 3) + axis] = word(order);
                }
            }
            EXPECT_EQ(differ(kernel, machine, words, 3, 1, random), 0) << text(of);
        }
    }
}

// Random words, not of a curve: no row of either is cut to its word.
TEST(CurveKernel, OfLinesOfEveryShapeHasTheirWords) {
    const auto table = std::make_shared<ref::CurveTable>(ref::read_curve_table(SHAPES_TABLE));
    std::mt19937_64 random(4);
    for (CurveCase of : configurations()) {
        if (of.spline) continue;
        ref::add_table(table, of.core);
        of.core.anchor = static_cast<int>(random() % 2);
        of.core.parameter_guard = static_cast<int>(random() % 9);
        const Format format(of.core, of.core.axes());
        hls::ShapesCurve<Format> kernel(format);
        sysc::TableKernel machine(*table, format);
        for (int n = 0; n < cases(5, 200); ++n) {
            const auto word = [&] {
                const double most = std::ldexp(1.0, of.core.coef_bits - 4);
                return static_cast<std::int64_t>(
                    std::uniform_real_distribution<double>(-most, most)(random));
            };
            sysc::RunSegment words;
            words.step_exponent = std::min(hls::kMaxStepExponent, of.core.position_bits - 6);
            words.lambda = words.step_exponent + static_cast<int>(random() % 3);
            words.theta = word();
            for (int axis = 0; axis < 3; ++axis) {
                words.tangent[axis] = word();
                words.normal[axis] = word();
                words.advance[axis] = word();
            }
            for (auto& further : words.further) further = word();
            EXPECT_EQ(differ(kernel, machine, words, 3, 3, random), 0) << text(of);
        }
    }
}

ref::CurveTable changed(const std::string& from, const std::string& to) {
    std::string text =
        "curve bent a curve\nword c[3] -2\nbus tangent c\noutput x\nanchor\n"
        "  x[k].1 : -2 = c[k]\n  e[k] : -3 = 1/2 c[k]\n"
        "next\n  move[k] : -2 = sum(x[k])\n";
    text.replace(text.find(from), from.size(), to);
    return ref::read_curve_text("bent.net", text);
}

std::string refusal(const ref::CurveTable& table) {
    try {
        hls::kernel_text(table, table.text);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CurveKernel, RefusesWhatNoStatementSays) {
    EXPECT_EQ(refusal(changed("anchor", "anchor")), "");
    EXPECT_EQ(refusal(changed("word c", "const half -2 0.5\nword c")),
              "bent.net:1: error: half: a kernel of C++ takes whole numbers as constants alone");
    EXPECT_EQ(refusal(changed("1/2 c[k]", "1/2 c[k]\n  e[k] : -3 = e[*]*c[*]")),
              "bent.net:8: error: a kernel of C++ makes e[k] axis by axis: what it takes of all "
              "axes is made in a row of its own");
    EXPECT_EQ(refusal(changed("1/2 c[k]", "1/2 c[k]\n  f[k] : +16 = e[k]*c[k]")),
              "bent.net:8: error: a kernel of C++ rounds products: these are coarser than their "
              "line");
    EXPECT_EQ(refusal(changed("sum(x[k])",
                              "sum(x[k])\nsample\n  e[k] : -3 = c[k]\n"
                              "  d[k] : -2 = e[k]")),
              "bent.net:11: error: a kernel of C++ makes what `sample` makes there alone: e is "
              "made or read elsewhere, too");
    EXPECT_EQ(refusal(changed("1/2 c[k]", "1/2")),
              "bent.net:7: error: a kernel of C++ takes whole numbers as constants alone");
}

}  // namespace curvecore::tb::curve_kernel_test
