// SPDX-License-Identifier: Apache-2.0
// Comments that name a table's curve, and the moves that end it.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/program/gcode_stream.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::tb::named_curve_test {

constexpr const char* kTable = R"(
curve circle
word kappa +1
start T[3] -2  N[3] -2
bus theta kappa  tangent T  normal N
output x
order
  DT[k] : -2 = kappa*N[k]'
  DN[k] : -2 = - kappa*T[k]'
  N[k] : -2 = DN[k]/i
  T[k] : -2 = DT[k]/i
  x[k] : -2 = T[k]'/i
next
  move[k] : -2 = sum(x[k])
  T[k] : -2 = T[k] + sum(T[k])
  N[k] : -2 = N[k] + sum(N[k])
)";

class NamedCurve : public testing::Test {
  protected:
    NamedCurve() {
        auto table = std::make_shared<ref::CurveTable>(ref::read_curve_text("circle.net", kTable));
        table->powers = ref::row_powers(*table);
        options_.table = table;
    }

    std::vector<ref::Move> read(const std::string& text) const {
        std::istringstream stream(text);
        ref::GcodeStream program(stream, "p.ngc", options_);
        std::vector<ref::Move> moves;
        for (ref::Move move; program.next(move);) moves.push_back(move);
        return moves;
    }
    std::string refusal(const std::string& text) const {
        try {
            read(text);
        } catch (const ref::InputError& error) {
            return error.what();
        }
        return "";
    }

    ref::GcodeOptions options_;
};

constexpr const char* kHalf = "(curve, circle, T=1 0 0, N=0 1 0, kappa=0.1, length=31.4159265)";

TEST_F(NamedCurve, EndsAtTheMoveBehindIt) {
    const auto moves =
        read(std::string("F600 G1 X5\n") + kHalf + "\nG1 X5 Y20 (half a circle)\nG1 X0\n");
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[1].kind, ref::Move::Kind::kTable);
    EXPECT_EQ(moves[1].line, 3);
    EXPECT_EQ(moves[1].feed, 10);
    EXPECT_NEAR(moves[1].length(), 31.4159265, 1e-12);
    // The curve is drawn as it is, what follows starts at its end.
    EXPECT_NEAR(moves[1].end.y(), 10 - 10 * std::cos(3.14159265), 1e-9);
    EXPECT_EQ(moves[2].kind, ref::Move::Kind::kLine);
    EXPECT_EQ(moves[2].start, moves[1].end);
    EXPECT_EQ(moves[2].end.x(), 0);
    // On the same line, in other letters
    const auto same = read(
        "F600 G1 X5\nG1 X5 Y20 (Curve , circle, kappa = .1 , length=31.4159265,"
        "N=0 1 0,T=1 0 0)\n");
    ASSERT_EQ(same.size(), 2U);
    EXPECT_EQ(same[1].end, moves[1].end);
}

TEST_F(NamedCurve, IsInTheProgramsUnits) {
    const auto moves = read(std::string("G20 F60\n") + kHalf + "\nG1 X0 Y20\n");
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_NEAR(moves[0].length(), 25.4 * 31.4159265, 1e-9);
    EXPECT_NEAR(moves[0].end.y(), 25.4 * 20, 1e-3);
    EXPECT_NEAR(moves[0].table.theta, 0.1 / 25.4, 1e-15);
}

TEST_F(NamedCurve, WhatItCannotBeIsNamedWithItsLine) {
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = kHalf;
        text.replace(text.find(from), from.size(), to);
        return "F600\n" + text + "\nG1 Y20\n";
    };
    const std::pair<std::string, const char*> cases[] = {
        {with("circle", "ellipse"), "p.ngc:2: error: a curve 'ellipse': --curve ellipse names"},
        {with("kappa=0.1", "kapa=0.1"), ":2: error: circle takes N, T, kappa, length, not 'kapa'"},
        {with("kappa=0.1, ", ""), ":2: error: this circle needs kappa=.."},
        {with(", length=31.4159265", ""), ":2: error: this circle needs length=.."},
        {with("length=31.4159265", "length=-3"), ":2: error: the length of this circle is one"},
        {with("kappa=0.1", "kappa=x"), ":2: error: 'kappa=x' of this circle: expected ROW=NUMBER"},
        {with("kappa=0.1", "kappa=nan"), ":2: error: 'kappa=nan' of this circle: expected"},
        {with("kappa=0.1", "kappa"), ":2: error: 'kappa' of this circle: expected ROW=NUMBER"},
        {with("kappa=0.1", "kappa=1 2"), ":2: error: kappa of this circle takes one number, not 2"},
        {with("T=1 0 0", "T=1 0"), ":2: error: T of this circle takes one number or three, not 2"},
        {with("T=1 0 0", "T=1 0 0, T=1 0 0"), ":2: error: T of this circle stands there twice"},
        {with("T=1 0 0", "T=1.1 0 0"),
         ":3: error: this circle: its rows are none of a path: |dr/ds|"},
        {with("0.1", "0.11"), ":3: error: this circle ends "},
        {with("0.1", "1e9"), ":3: error: this circle: its series do not converge"},
        {"F600\n" + std::string(kHalf) + "\n" + kHalf, ":3: error: the curve of line 2 waits"},
        {"F600\n" + std::string(kHalf) + "\nG0 Y20\n", ":3: error: the curve of line 2 waits"},
        {"F600\n" + std::string(kHalf) + "\nG1 Y20 A3\n", ":3: error: the curve of line 2 waits"},
        {"F600\nG1 X1\n" + std::string(kHalf) + "\nM2\n", ":3: error: the curve of line 3 waits"},
        {"F600 G10 L2 P1 R30\n" + std::string(kHalf) + "\nG1 Y20\n", "turned coordinates"},
    };
    for (const auto& [text, reason] : cases) {
        EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << refusal(text) << "\n"
                                                                 << reason;
    }
}

/// A comment that names a curve without its table is refused: the move would be its chord.
TEST_F(NamedCurve, NeedsItsTable) {
    options_.table.reset();
    EXPECT_NE(refusal(std::string(kHalf) + "\nG1 Y20 F600\n").find("--curve circle"),
              std::string::npos);
    EXPECT_NE(refusal("(curve,)\nG1 Y20 F600\n").find("a curve ''"), std::string::npos);
    options_.dialect = ref::Dialect::kGrbl;
    EXPECT_NE(refusal(std::string(kHalf) + "\nG1 Y20 F600\n").find("--curve circle"),
              std::string::npos);
    // Other comments stay comments.
    options_.dialect.reset();
    EXPECT_EQ(refusal("(curve to the left)\n(curved, x)\n;(curve, x)\n(old (curve, x))\nG1 Y20 "
                      "F600\n"),
              "");
}

}  // namespace curvecore::tb::named_curve_test
