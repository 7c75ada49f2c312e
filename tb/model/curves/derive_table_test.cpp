// SPDX-License-Identifier: Apache-2.0
// Formulas: what they are read as, their derivatives, and the tables that are derived of them,
// which draw the formula's curve at constant path speed.
#include "ref/curves/derive/derive_table.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <random>
#include <set>

#include "hls/quantise.hpp"
#include "ref/curve/drawn/table_curve.hpp"
#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/segment/table_segment.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "sysc/kernel/run_time_kernel.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb::derive_table_test {

using ref::Vec3;

double value(const std::string& text, double t, const std::map<std::string, double>& with = {}) {
    ref::Formulas formulas;
    return formulas.value(formulas.read(text, with), t);
}

TEST(Formula, IsReadAsItIsWritten) {
    EXPECT_EQ(value("1 + 2*3 - 4/8", 0), 6.5);
    EXPECT_EQ(value("-t^2", 3), -9);
    EXPECT_NEAR(value("2^-t", 3), 0.125, 1e-15);
    EXPECT_EQ(value("2^3^2", 0), 512);
    EXPECT_EQ(value("(1 - t)*(1 + t)", 3), -8);
    EXPECT_EQ(value("a*b - t/-2", 4, {{"a", 3}, {"b", 5}}), 17);
    EXPECT_NEAR(value("sin(t)^2 + cos(t)^2", 0.7), 1, 1e-15);
    EXPECT_NEAR(value("tan(t) - sinh(t) + cosh(t)*tanh(t)", 0.7), std::tan(0.7), 1e-15);
    EXPECT_NEAR(value("exp(log(t)) * sqrt(t) + atan(1)*4/pi", 0.7), 0.7 * std::sqrt(0.7) + 1,
                1e-15);
    EXPECT_NEAR(value("t^2.5 - t^-0.5 + 1.5e1", 0.7), std::pow(0.7, 2.5) - 1 / std::sqrt(0.7) + 15,
                1e-14);
}

TEST(Formula, ThatIsNoneIsNamed) {
    const auto refusal = [](const std::string& text) {
        try {
            value(text, 0);
        } catch (const ref::FormulaError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal("1 +"), "'1 +': expected a number, a name or '(', not the end");
    EXPECT_EQ(refusal("2 t"), "'2 t': expected an operator, not 't'");
    EXPECT_EQ(refusal("(t"), "'(t': expected ')', not the end");
    EXPECT_EQ(refusal("q*t"), "'q*t': q has no value: --let q=..");
    EXPECT_EQ(refusal("gamma(t)"), "'gamma(t)': there is no function gamma");
    EXPECT_EQ(refusal("1/0"), "a number of it is not finite");
    EXPECT_EQ(refusal("t^1000"), "a power above 64");
    EXPECT_EQ(refusal(std::string(5000, '(') + "t"), "'" + std::string(5000, '(') + "t': too deep");
    EXPECT_EQ(refusal(""), "'': expected a number, a name or '(', not the end");
}

/// Derivatives are difference quotients, of every function.
TEST(Formula, HasItsDerivative) {
    for (const char* text : {"sin(2*t)", "cos(t^2)", "tan(t)", "sinh(t)", "cosh(t)", "tanh(t)",
                             "exp(-t^2)", "log(1 + t^2)", "sqrt(2 + t)", "atan(3*t)", "t^3 - 4*t",
                             "1/(1 + t)", "t^2.5", "2^t", "t*sin(t)/(2 + cos(t))", "t^-2"}) {
        ref::Formulas formulas;
        const int whole = formulas.read(text, {});
        const int slope = formulas.derivative(whole);
        for (const double t : {0.3, 0.9, 1.4}) {
            constexpr double kStep = 1e-5;
            const double quotient =
                (formulas.value(whole, t + kStep) - formulas.value(whole, t - kStep)) / (2 * kStep);
            EXPECT_NEAR(formulas.value(slope, t), quotient, 1e-7 * (1 + std::abs(quotient)))
                << text;
        }
    }
}

/// Formulas of every function, with ends between which they are smooth.
const std::vector<ref::CurveFormula>& curves() {
    static const std::vector<ref::CurveFormula> kCurves{
        {"trochoid", {"R*t - d*sin(t)", "R - d*cos(t)"}, {{"R", 10}, {"d", 6}}, 0.2, 7},
        {"bump", {"15*t", "20*exp(-t^2)"}, {}, -2, 2},
        {"witch", {"12*t", "20/(1 + t^2)"}, {}, -3, 3},
        {"lissajous", {"30*sin(3*t)", "25*sin(2*t + 0.7)"}, {}, 0, 2},
        {"cone", {"(5 + t)*cos(t)", "(5 + t)*sin(t)", "3*t"}, {}, 0, 12},
        {"powers", {"10*t", "20*sqrt(t)", "t^2.5"}, {}, 0.3, 3},
        {"logs", {"10*t", "8*log(1 + t)*atan(t)"}, {}, 0, 4},
        {"hyperbolic", {"10*sinh(t)", "6*cosh(t)", "5*tanh(t)"}, {}, -1.5, 1.2},
        {"tangents", {"20*t", "5*tan(t)"}, {}, -1, 1},
        {"parabola", {"t", "t^2/40"}, {}, -30, 50},
        {"astroid", {"40*cos(t)^3", "40*sin(t)^3"}, {}, 0.2, 1.3},
        {"nested", {"10*t", "4*sin(2*t + sin(3*t))"}, {}, 0, 4},
    };
    return kCurves;
}

/// The curve of a formula, by a table that is derived of it, and in closed form.
class DerivedCurve {
  public:
    explicit DerivedCurve(const ref::CurveFormula& formula)
        : formula_(formula), made_(ref::derive_table(formula)) {
        auto table = std::make_shared<ref::CurveTable>(
            ref::read_curve_text(formula.name + ".net", made_.text));
        table->powers = ref::row_powers(*table);
        table_ = table;
        for (const std::string& text : formula.coordinates) {
            places_.push_back(formulas_.read(text, formula.constants));
        }
        for (const int place : places_) slopes_.push_back(formulas_.derivative(place));
    }

    std::shared_ptr<const ref::CurveTable> table() const { return table_; }
    double length() const { return made_.length; }
    Vec3 start() const { return Vec3(made_.start[0], made_.start[1], made_.start[2]); }
    ref::TablePiece piece() const {
        ref::TablePiece piece;
        piece.table = table_.get();
        for (const auto& [place, row] : table_->bus) {
            const int axes = table_->rows.at(row).of_axis ? 3 : 1;
            for (int axis = 0; axis < axes; ++axis) {
                piece.at(place, axis) = made_.rows.at(row)[static_cast<std::size_t>(axis)];
            }
        }
        return piece;
    }

    /// The place of a path length: by bisection of its integral.
    Vec3 at(double s) const {
        double least = formula_.from;
        double most = formula_.to;
        double begun = 0;  // path up to `least`
        for (int n = 0; n < 60; ++n) {
            const double middle = (least + most) / 2;
            const double path = begun + integral(least, middle);
            if (path < s) begun = path;
            (path < s ? least : most) = middle;
        }
        const std::vector<double> values = formulas_.values((least + most) / 2);
        Vec3 place = Vec3::Zero();
        for (std::size_t n = 0; n < places_.size(); ++n) {
            place[static_cast<Eigen::Index>(n)] = values[static_cast<std::size_t>(places_[n])];
        }
        return place;
    }

  private:
    double integral(double from, double to) const {
        double sum = 0;
        constexpr int kParts = 16;
        const auto speed = [&](double t) {
            const std::vector<double> values = formulas_.values(t);
            double squares = 0;
            for (const int slope : slopes_) {
                squares += std::pow(values[static_cast<std::size_t>(slope)], 2);
            }
            return std::sqrt(squares);
        };
        for (int part = 0; part < kParts; ++part) {
            sum += boost::math::quadrature::gauss<double, 20>::integrate(
                speed, from + (to - from) * part / kParts,
                from + (to - from) * (part + 1) / kParts);
        }
        return sum;
    }

    ref::CurveFormula formula_;
    ref::DerivedTable made_;
    std::shared_ptr<const ref::CurveTable> table_;
    ref::Formulas formulas_;
    std::vector<int> places_;
    std::vector<int> slopes_;
};

class FormulaCurve : public testing::TestWithParam<ref::CurveFormula> {};

TEST_P(FormulaCurve, IsTheCurveOfItsTable) {
    const DerivedCurve exact(GetParam());
    const ref::TableCurve curve(exact.piece(), exact.start(), exact.length());
    for (const double part : {0.0, 0.11, 0.37, 0.5, 0.78, 1.0}) {
        const double s = part * exact.length();
        EXPECT_LT((curve.position(s) - exact.at(s)).norm(), 1e-10 * exact.length()) << part;
        EXPECT_NEAR(curve.direction(s).norm(), 1, 1e-11);
    }
}

TEST_P(FormulaCurve, IsDrawnInWordsWithinItsBound) {
    constexpr double kUnit = 1e-6;  // mm
    const DerivedCurve exact(GetParam());
    ref::PlanOptions options;
    ref::add_table(exact.table(), options.format);
    const sysc::RunTimeFormat format(options.format, 3);
    // A part of the curve: its bound takes some milliseconds a step.
    const double from = 0.4 * exact.length();
    const double length = std::min(0.1 * exact.length(), 4.0);
    const ref::TableCurve whole(exact.piece(), exact.start(), exact.length());
    const ref::TableCurve curve(whole.piece_at(from).rescaled(1 / kUnit),
                                whole.position(from) / kUnit, length / kUnit);
    double begin = 0;
    double most = 0;
    for (const ref::Segment& segment : ref::cut_table(curve, options)) {
        const sysc::RunSegment words = hls::to_words(segment, format);
        sysc::RunTimeKernel kernel(format);
        const auto last = static_cast<std::int64_t>(segment.length);
        std::int64_t at = 0;
        for (int sample = 0; sample < 10; ++sample) {
            const std::int64_t ds = (last - at) / (10 - sample) - 1;
            std::int64_t fine[sysc::kMostAxes];
            kernel.sample(
                ds, [&] { return words; }, fine);
            at += ds;
            const double s = begin + std::ldexp(static_cast<double>(at), -16);
            const Vec3 place = exact.at(from + s * kUnit) / kUnit;
            for (int axis = 0; axis < 3; ++axis) {
                const double drawn = std::ldexp(static_cast<double>(fine[axis]), -10);
                ASSERT_LT(std::abs(drawn - place[axis]), segment.bound + 1e-4);
                most = std::max(most, std::abs(drawn - place[axis]) / segment.bound);
            }
        }
        begin += std::ldexp(static_cast<double>(segment.length), -16);
    }
    EXPECT_NEAR(begin, length / kUnit, 1);
    EXPECT_GT(most, 0.02) << "of the bound";
}

/// The engine has room for formulas of few functions; what has more is refused with a reason.
TEST_P(FormulaCurve, IsTheEnginesIfItHasRoom) {
    static const std::set<std::string> kTooMany{"astroid", "hyperbolic", "powers", "tangents"};
    const DerivedCurve exact(GetParam());
    try {
        assembler::curve_program(*exact.table(), {});
        EXPECT_EQ(kTooMany.count(GetParam().name), 0U);
    } catch (const assembler::AssemblyError& error) {
        EXPECT_EQ(kTooMany.count(GetParam().name), 1U) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(, FormulaCurve, testing::ValuesIn(curves()),
                         [](const auto& of) { return of.param.name; });

TEST(DerivedTable, WhatCannotBeDrawnIsRefused) {
    const auto refusal = [](const std::vector<std::string>& coordinates, double from, double to) {
        try {
            ref::derive_table({"c", coordinates, {}, from, to});
        } catch (const ref::FormulaError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal({"t", "3*t + 1"}, 0, 1), "a straight line: it needs no table");
    EXPECT_EQ(refusal({"t", "t^2"}, 1, 0), "t goes from less to more");
    EXPECT_NE(refusal({"t^2", "t^3"}, -1, 1).find("near t = 0 the curve all but stands still"),
              std::string::npos);
    EXPECT_NE(refusal({"t", "t^2/1e6"}, 0, 1e5).find("let t have another scale"),
              std::string::npos);
    EXPECT_NE(refusal({"t", "log(t)"}, 0, 1).find("at t = 0 the curve has no slope"),
              std::string::npos);
    std::string many = "0.1*sin(t)";
    for (int n = 2; n < 12; ++n) many += "+0.1*sin(" + std::to_string(n) + "*t + sin(t))";
    EXPECT_NE(refusal({"t", many}, 0, 1).find("a segment has words for 16 in all"),
              std::string::npos);
}

/// Random formulas: the table's curve ends where the formula does.
TEST(DerivedTable, DrawsAnyFormula) {
    std::mt19937_64 random(3);
    const auto one_of = [&](std::initializer_list<const char*> texts) {
        return std::string(*(texts.begin() + random() % texts.size()));
    };
    const std::function<std::string(int)> any = [&](int depth) -> std::string {
        if (depth == 0) return one_of({"t", "t", "0.5", "2", "1.3"});
        const std::string a = any(depth - 1);
        const std::string b = any(static_cast<int>(random() % static_cast<unsigned>(depth)));
        const std::string form =
            one_of({"(A + B)", "(A - B)", "A*B", "sin(A)", "cos(A)", "exp(-(A)^2)", "atan(A)",
                    "A/(2 + (B)^2)", "sqrt(2 + (A)^2)", "log(2 + (A)^2)"});
        std::string text;
        for (const char c : form) text += c == 'A' ? a : c == 'B' ? b : std::string(1, c);
        return text;
    };
    int drawn = 0;
    for (int n = 0; n < cases(60, 3000); ++n) {
        const ref::CurveFormula formula{"any", {"3*t", any(1 + n % 3)}, {}, -1, 1.5};
        try {
            const DerivedCurve exact(formula);
            const ref::TableCurve curve(exact.piece(), exact.start(), exact.length());
            EXPECT_LT((curve.position(exact.length()) - exact.at(exact.length())).norm(), 1e-9)
                << formula.coordinates[1];
            ++drawn;
        } catch (const ref::FormulaError& error) {
            const std::string why = error.what();
            EXPECT_TRUE(why.find("straight") != std::string::npos ||
                        why.find("words for") != std::string::npos ||
                        why.find("more than a word holds") != std::string::npos)
                << formula.coordinates[1] << ": " << why;
        }
    }
    EXPECT_GT(drawn, cases(15, 750));
}

}  // namespace curvecore::tb::derive_table_test
