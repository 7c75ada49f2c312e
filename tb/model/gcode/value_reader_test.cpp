// SPDX-License-Identifier: Apache-2.0
// Expressions of RS274/NGC against closed forms, and parameters: when they are assigned, and which
// may be.
#include "ref/gcode/blocks/value_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ref/gcode/blocks/block.hpp"
#include "ref/gcode/lines/program_lines.hpp"
#include "ref/program/gcode_reader.hpp"

namespace curvecore::tb::value_reader_test {

using ref::InputError;
using ref::ProgramParameters;

const std::string kFile = "part.ngc";

/// #1 is 3, #2 is -7.5, #3 is 2, #<name> is 11, #<_everywhere> is 13.
ProgramParameters parameters() {
    ProgramParameters given;
    given.assign(1, 3);
    given.assign(2, -7.5);
    given.assign(3, 2);
    given.assign("name", 11);
    given.assign("_everywhere", 13);
    return given;
}

double value(const std::string& text) {
    const ref::Place place{kFile, 7};
    const std::string words = ref::words_of(text, place);
    const ProgramParameters given = parameters();
    ref::ValueReader reader(words, given, place);
    const double found = reader.value("X");
    EXPECT_TRUE(reader.at_end()) << text << ": " << reader.rest();
    return found;
}

std::string refusal(const std::string& text) {
    try {
        return std::to_string(value(text));
    } catch (const InputError& error) {
        return error.what();
    }
}

double degrees(double radians) { return radians * 180 / M_PI; }

TEST(ValueReader, NumbersAreDecimal) {
    EXPECT_EQ(value("12.25"), 12.25);
    EXPECT_EQ(value("-.5"), -0.5);
    EXPECT_EQ(value("+5."), 5);
    EXPECT_EQ(value("0 0 1 2 . 5"), 12.5);
}

TEST(ValueReader, OperatorsBindAsLinuxcncHasThem) {
    EXPECT_EQ(value("[2+3*4]"), 14);
    EXPECT_EQ(value("[2*3**2]"), 18);
    EXPECT_EQ(value("[2**3**2]"), 64);  // from left to right
    EXPECT_EQ(value("[-2**2]"), 4);     // the sign belongs to the number
    EXPECT_EQ(value("[-#1**2]"), 9);
    EXPECT_EQ(value("[10-4-3]"), 3);
    EXPECT_EQ(value("[100/10/5]"), 2);
    EXPECT_EQ(value("[7 mod 4 * 2]"), 6);
    EXPECT_EQ(value("[1+1 eq 2]"), 1);
    EXPECT_EQ(value("[1 or 0 and 0]"), 0);  // the same binding, from left to right
    EXPECT_EQ(value("[1 lt 2 and 3 gt 2]"), 1);
    EXPECT_EQ(value("[3 gt 2 gt 0]"), 1);
    EXPECT_EQ(value("[2-3 lt 0 xor 1]"), 0);
    EXPECT_EQ(value("[[2+3]*[4-1]]"), 15);
}

TEST(ValueReader, RemaindersArePositive) {
    EXPECT_EQ(value("[-7 mod 3]"), 2);
    EXPECT_EQ(value("[7 mod -3]"), 1);
    EXPECT_EQ(value("[7.5 mod 2]"), 1.5);
}

TEST(ValueReader, ComparisonsTakeAMillionthForNothing) {
    EXPECT_EQ(value("[1 eq 1.0000009]"), 1);
    EXPECT_EQ(value("[1 eq 1.0000011]"), 0);
    EXPECT_EQ(value("[1 ne 1.0000009]"), 0);
    EXPECT_EQ(value("[1 ge 1.0000009]"), 1);
    EXPECT_EQ(value("[1.0000009 le 1]"), 1);
    EXPECT_EQ(value("[1 lt 1.0000009]"), 1);
    EXPECT_EQ(value("[1 gt 1.0000009]"), 0);
}

TEST(ValueReader, FunctionsAreThoseOfDegrees) {
    EXPECT_NEAR(value("sin[30]"), 0.5, 1e-15);
    EXPECT_NEAR(value("cos[60]"), 0.5, 1e-15);
    EXPECT_NEAR(value("tan[45]"), 1, 1e-15);
    EXPECT_NEAR(value("asin[0.5]"), 30, 1e-13);
    EXPECT_NEAR(value("acos[0.5]"), 60, 1e-13);
    EXPECT_NEAR(value("atan[1]/[-1]"), 135, 1e-13);
    EXPECT_NEAR(value("atan[-1]/[0]"), -90, 1e-13);
    EXPECT_NEAR(value("atan[3]/[4]"), degrees(std::asin(0.6)), 1e-13);
    EXPECT_NEAR(value("exp[1]"), 2.718281828459045, 1e-15);
    EXPECT_NEAR(value("ln[exp[2.5]]"), 2.5, 1e-15);
    EXPECT_EQ(value("sqrt[2.25]"), 1.5);
    EXPECT_EQ(value("abs[-3]"), 3);
    EXPECT_EQ(value("-abs[-3]"), -3);
}

TEST(ValueReader, RoundingIsDownUpAndAwayFromZeroAtAHalf) {
    EXPECT_EQ(value("fix[2.8]"), 2);
    EXPECT_EQ(value("fix[-2.8]"), -3);
    EXPECT_EQ(value("fup[2.2]"), 3);
    EXPECT_EQ(value("fup[-2.8]"), -2);
    EXPECT_EQ(value("round[2.5]"), 3);
    EXPECT_EQ(value("round[-2.5]"), -3);
    EXPECT_EQ(value("round[2.49]"), 2);
}

TEST(ValueReader, ParametersAreFoundByNumberAndByName) {
    EXPECT_EQ(value("#1"), 3);
    EXPECT_EQ(value("##3"), -7.5);  // #2
    EXPECT_EQ(value("#[#3+0.00009]"), -7.5);
    EXPECT_EQ(value("#1.0"), 3);
    EXPECT_EQ(value("-#2"), 7.5);
    EXPECT_EQ(value("--#2"), -7.5);
    EXPECT_EQ(value("#<Name>"), 11);
    EXPECT_EQ(value("[#<_every where>+#1]"), 16);
    EXPECT_EQ(value("#4999"), 0);
    EXPECT_EQ(value("exists[#<name>]"), 1);
    EXPECT_EQ(value("exists[#<_name>]"), 0);
    EXPECT_EQ(value("exists[#5601]"), 1);
    EXPECT_EQ(value("exists[#5602]"), 0);
}

/// Many expressions whose value is known by construction.
TEST(ValueReader, RandomPolynomialsAreThoseOfHorner) {
    unsigned state = 1;
    const auto next = [&state] { return (state = state * 1664525U + 1013904223U) >> 16; };
    for (int i = 0; i < 2000; ++i) {
        const double x = static_cast<double>(next() % 200) / 8 - 12;
        std::string powers;
        std::string horner;
        double expected = 0;
        for (int degree = 4; degree >= 0; --degree) {
            const int factor = static_cast<int>(next() % 19) - 9;
            expected = expected * x + factor;
            powers += (powers.empty() ? "" : "+") + std::to_string(factor) + "*" +
                      std::to_string(x) + "**" + std::to_string(degree);
            horner = horner.empty()
                         ? std::to_string(factor)
                         : "[" + horner + "]*" + std::to_string(x) + "+" + std::to_string(factor);
        }
        const double scale = 1e-13 * (1 + std::pow(std::abs(x), 4) * 50);
        ASSERT_NEAR(value("[" + powers + "]"), expected, scale) << powers;
        ASSERT_NEAR(value("[" + horner + "]"), expected, scale) << horner;
    }
}

TEST(ValueReader, WhatHasNoValueIsRefused) {
    const std::pair<const char*, const char*> cases[] = {
        {"[1/0]", "1/0 has no value"},
        {"[5 mod 0]", "5MOD0 has no value"},
        {"[[0-8]**0.5]", "-8**0.5 has no value"},
        {"[10**308*10]", "1e+308*10 has no value"},
        {"sqrt[-1]", "SQRT[-1] has no value"},
        {"ln[0]", "LN[0] has no value"},
        {"asin[1.5]", "ASIN[1.5] has no value"},
        {"#0", "there is no #0: parameters are #1 to #5601"},
        {"#5602", "there is no #5602: parameters are #1 to #5601"},
        {"#1.5", "# wants a whole number, not 1.5"},
        {"#<nobody>", "#<nobody> has no value yet: assign it before"},
        {"#<_ini[traj]x>", "#<_ini[traj]x> is no number of the machine's .ini: --machine names it"},
        {"#<_hal[a.b]>",
         "#<_hal[a.b]> is a pin of LinuxCNC's machine while it runs: give its value in a line "
         "before, as #<_hal[a.b]>=1"},
        {"#<name", "a name without its closing >"},
        {"#<>", "<> without a name"},
        {"[1+2", "an expression without its closing ]"},
        {"[1 2+3 4 &]", "'&' where an operator or ] should be"},
        {"[]", "X with empty brackets"},
        {"[1+]", "an expression without a number"},
        {"[1+*2]", "an expression without a number"},
        {"sinus[1]",
         "there is no function SINUS (ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN "
         "ROUND SIN SQRT TAN)"},
        {"atan[1]", "ATAN wants two values, as in ATAN[y]/[x]"},
        {"exists[1]", "EXISTS wants a parameter in brackets, as in EXISTS[#<name>]"},
        {"exists[#1+1]", "EXISTS wants nothing but a parameter in its brackets"},
        {"1.2.3", "X1.2.3 is not a number"},
        {"sin", "X without a number"},
    };
    for (const auto& [text, reason] : cases) {
        EXPECT_EQ(refusal(text), std::string("part.ngc:7: error: ") + reason) << text;
    }
    EXPECT_EQ(refusal(std::string(200, '[') + "1" + std::string(200, ']')),
              "part.ngc:7: error: the expression nests deeper than 100: split it by parameters");
}

std::string refusal_of_program(const std::string& text) {
    try {
        ref::read_gcode_text(text, kFile);
        return "nothing is wrong";
    } catch (const InputError& error) {
        return error.what();
    }
}

ref::Move last(const std::string& text) {
    return ref::read_gcode_text("G90 F600\n" + text, kFile).moves.back();
}

TEST(Parameters, AreAssignedBehindTheirLine) {
    EXPECT_EQ(last("#1=10 #<deep>=2\n#1=20 G1 X#1 Y[#<deep>*#1]\n").end, ref::Vec3(10, 20, 0));
    EXPECT_EQ(last("#1=10\n#1=20 #2=#1\nG1 X#1 Y#2\n").end, ref::Vec3(20, 10, 0));
    EXPECT_EQ(last("#1=4 #1=5\nG1 X#1\n").end.x(), 5);
    EXPECT_EQ(last("#<n>=[#<n>+1]\nG1 X#<n>\n").end.x(), 1);  // as LinuxCNC: 0 before
}

TEST(Parameters, AreCodesToo) {
    EXPECT_EQ(last("#1=1\nG#1 X[1/3]\n").end.x(), 1.0 / 3);
    EXPECT_EQ(last("#1=20.00009\nG#1 G1 X1\n").end.x(), 25.4);
}

TEST(Parameters, HavePositionsAndModes) {
    EXPECT_EQ(last("G92 X5\nG1 X7 Y3\nG1 X[#5420+1] Y[#<_y>*2]\n").end, ref::Vec3(3, 6, 0));
    EXPECT_EQ(last("G1 X50.8\nG20\nG1 Y#5420 Z[#5021+#<_abs_x>]\n").end,
              ref::Vec3(50.8, 50.8, 101.6));
    EXPECT_EQ(last("G10 L2 P2 X3\nG55 G1 X1 A4\nG1 X#<_x> Y#<_abs_x> Z#<_a>\n").end,
              ref::Vec3(4, 4, 4));
    EXPECT_EQ(last("G18 G91 G1 X1\nG90 G1 X#<_plane> Y#<_coord_system> Z#<_motion_mode>\n").end,
              ref::Vec3(180, 540, 10));
    EXPECT_EQ(last("F300\nG1 X#<_feed> Y#<_metric> Z#<_absolute>\n").end, ref::Vec3(300, 1, 1));
}

TEST(Polar, CoordinatesAreThoseOfTheProgramsZero) {
    const auto near = [](const std::string& text, double x, double y) {
        const ref::Move move = last(text);
        EXPECT_NEAR(move.end.x(), x, 1e-12) << text;
        EXPECT_NEAR(move.end.y(), y, 1e-12) << text;
    };
    near("G1 @10 ^30\n", 10 * std::sqrt(0.75), 5);
    near("G1 X3 Y4\n@10\n", 6, 8);
    near("G1 X3 Y4\n^90\n", 0, 5);
    near("G1 X3 Y4\nG91 @5 ^90\n", -8, 6);
    near("G92 X-10\nG20 G1 @1 ^[45+45] Z1\n", 10, 25.4);
    near("G1 @10 ^0\nG3 @10 ^90 I-10 J0\n", 0, 10);
}

TEST(Parameters, AreRefusedWithTheirLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"#5420=1", "#5420 can only be read"},
        {"#5400=1", "#5400 can only be read"},
        {"#<_x>=1", "#<_x> can only be read"},
        {"#5700=1", "there is no #5700: parameters are #1 to #5601"},
        {"#1", "a parameter that begins a word wants =, as in #1=5"},
        {"#1=", "= without a number"},
        {"G1 X#<length>", "#<length> has no value yet: assign it before"},
        {"G1 X[10**10]", "the number of X is out of range"},
        {"G#30.5 X1", "# wants a whole number, not 30.5"},
        {"G[1.05] X1", "G1.05 is not a code"},
        {"M[-3]", "M-3 is not a code"},
        {"G1 @5", "polar coordinates want the angle (^) in G90: the program's zero has none"},
        {"G91 G1 @5 ^3",
         "polar coordinates want the angle (^) in G90: the program's zero has none"},
        {"G1 @5 ^3 X2", "polar coordinates (@ ^) beside X or Y"},
        {"G53 G1 @5 ^3", "polar coordinates (@ ^) are of motion, not of G53"},
        {"G1 @5 @3", "@ twice in one block"},
        {"[1]", "'[' where a word should begin"},
    };
    for (const auto& [text, reason] : cases) {
        EXPECT_EQ(refusal_of_program(std::string("G90 F600\n") + text + "\n"),
                  std::string("part.ngc:2: error: ") + reason)
            << text;
    }
}

}  // namespace curvecore::tb::value_reader_test
