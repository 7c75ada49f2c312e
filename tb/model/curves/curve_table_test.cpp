// SPDX-License-Identifier: Apache-2.0
// Tables of curves as text: what is refused, and how far rows are needed.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "hls/registers/board_facts.h"
#include "ref/curves/order_demand.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref::curve_table_test {

constexpr char kHead[] =
    "curve c\nword theta -1  a[3] -2\nstart n[3] -2\nbus theta theta  tangent a  normal n\n"
    "output x\n";

constexpr char kOrders[] = "\norder\n  x[k] : -2 = n[k]'/i\n";

std::string refused(const std::string& lines, const std::string& after = "") {
    try {
        read_curve_text("c.net", kHead + lines + kOrders + after);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CurveTable, RefusalNamesFileLineAndReason) {
    const std::pair<const char*, const char*> cases[] = {
        {"anchor\n  y : -2 = b*theta", "c.net:7: error: no line before makes b"},
        {"anchor\n  y : -2 = a*theta", "c.net:7: error: a is a row of each axis: a[k]"},
        {"anchor\n  y : -2 = a[k]*theta", "c.net:7: error: y is no row of an axis, a[k] is"},
        {"anchor\n  y[k] : -2 = theta[k]", "c.net:7: error: theta is no row of an axis"},
        {"anchor\n  y : -2 = theta +", "c.net:7: error: expected the name of a row, not the end"},
        {"anchor\n  y = theta", "c.net:7: error: 'y' begins no line of a table"},
        {"anchor\n  y : = theta", "c.net:7: error: expected a number, not '= theta'"},
        {"anchor\n  y : -2 = 1/3 theta",
         "c.net:7: error: a factor is a number over a power of two"},
        {"anchor\n  y : -2 = theta theta", "c.net:7: error: expected + or -, not 'theta'"},
        {"anchor\n  y : -2 = theta.1", "c.net:7: error: theta has no orders"},
        {"anchor\n  y : -2 = theta/i", "c.net:7: error: /i has a meaning in `order` alone"},
        {"next\n  y : -2 = sum(theta)", "c.net:7: error: theta is no series"},
        {"next\n  y : -2 = sum(n[k])", "c.net:7: error: y is no row of an axis, n[k] is"},
        {"anchor\n  theta : -1 = 1", "c.net:7: error: theta is fixed: no line makes it"},
        {"anchor\n  y : -2 = theta\n  y : -1 = theta", "c.net:8: error: y has a fraction of -2"},
        {"anchor\n  y : -2 = theta*theta >> s", "c.net:7: error: >> s takes one row"},
        {"anchor\n  y : -2 = theta\nnext\n  y : -2 = n[*].13*n[*]",
         "c.net:9: error: an order above 12"},
        {"anchor\n  y : -2 = tau", "c.net:7: error: tau is a place in the step, in `sample` alone"},
        {"next\n  move[k] : -2 = horner(n[k])",
         "c.net:7: error: horner(..) is a polynomial in tau, in `sample` alone"},
        {"const n -2 1", "c.net:6: error: n is a row of each axis: no constant"},
        {"alias Dtheta theta", "c.net:6: error: theta has no orders"},
        {"load\n  y : -2 = theta\nanchor\n  y : -2 = 2 theta",
         "c.net:9: error: y is made in `load`, once for its segment"},
        {"word theta -1", "c.net:6: error: theta is there twice"},
        {"word b -99", "c.net:6: error: '-99' is no fraction: -16 .. 16 from CoefBits"},
        {"word b -2", "error: b comes from no word of the bus"},
        {"bus place theta", "c.net:6: error: the bus has no field place"},
        {"load\n  y[k] : -2 = n[k]", "c.net:7: error: n is no word of the segment"},
        {"anchor\n  y[k] : -2 = a[k]\nnext\n  y[k] : -2 = a[k]",
         "c.net:9: error: y is made in each step, and carried: it needs `start`"},
        {"next\n  y[k] : -2 = a[k]\nanchor", "c.net:8: error: `anchor` stands before `next`"},
        {"anchor\n  y.13 : -2 = theta", "c.net:7: error: an order above 12"},
        {"anchor\n  y : -2 = 0 theta", "c.net:7: error: a factor is not 0"},
        {"sample\n  y[k] : -2 = a[k] + horner(n[k])",
         "c.net:7: error: a polynomial takes no other term"},
        {"anchor\n  y[k] : -2 = sum(n[k])",
         "c.net:7: error: the orders are whole in `next`, `carry` and `sample` alone"},
        {"next\n  y[k] : -2 = sum(n[k]')",
         "c.net:7: error: a function takes all orders of its row"},
        {"order\n  y.1 : -2 = theta", "c.net:7: error: an order is named in `anchor` alone"},
        {"order\n  y : -2 = theta/i\n  y : -2 = theta",
         "c.net:8: error: line 7 makes the orders of y already"},
        {"order\n  n[k] : -2 = n[k]/i", "c.net:7: error: n has this order from here"},
        {"order\n  y[k] : -2 = n[k]\n  n[k] : -2 = y[k]/i",
         "c.net:7: error: n has this order from here or further down"},
        {"anchor\n  y[k] : -2 += a[k]", "c.net:7: error: += adds the axes to a row that has none"},
        {"anchor\n  move[k] : -2 = a[k]", "c.net:7: error: move is made in `next`"},
        {"anchor\n  place : -2 = theta", "c.net:7: error: place is a row of each axis"},
        {"anchor\n  place[k] : -1 = a[k]",
         "c.net:7: error: place is a place in the step: its fraction is -2"},
        {"const move -2 1", "error: move is made in `next`"},
        {"start d[3] -2\nbus advance d", "error: d is made in `sample`"},
        {"curve d", "c.net:6: error: a table has one `curve`"},
        {"output n", "c.net:6: error: a table has one `output`"},
        {"guard q", "error: guard: no line of `next` makes q"},
        {"guard theta", "error: guard: no line of `next` makes theta"},
        {"start p -1\nconst p -1 0\nguard p\nanchor\n  p : -1 = theta",
         "error: guard: no line of `next` makes p"},
        {"words b -2", "c.net:6: error: 'words' begins no line of a table"}};
    for (const auto& [lines, reason] : cases) {
        EXPECT_NE(refused(lines).find(reason), std::string::npos) << lines << "\n"
                                                                  << refused(lines);
    }
    EXPECT_EQ(refused("anchor\n  y : -2 = theta"), "");
}

TEST(CurveTable, GuardedRowsAreMadeOfEachOther) {
    const std::string carried = "start p -1\nconst p -1 0\nguard p q";
    const std::string shifted = "next\n  q : -1 = theta >> s\n";
    EXPECT_EQ(refused(carried, shifted + "  p : -1 = p + q"), "");
    EXPECT_EQ(refused(carried, shifted + "  p : -1 = p*theta"),
              "c.net:13: error: p is guarded: a line of `next` makes it, a sum of guarded rows or "
              "one other row >> s");
    EXPECT_EQ(refused(carried, shifted + "  p : -1 = p + q\n  y : -1 = q"),
              "c.net:14: error: a guarded row that is not carried is read by guarded rows alone");
}

TEST(CurveTable, GuardedRowsAreNoVariables) {
    const std::string carried = "start p -1\nconst p -1 0\nguard p q";
    EXPECT_EQ(refused(carried,
                      "next\n  q : -1 = theta >> s\n  p : -1 = p + q\nsample\n"
                      "  d[k] : -2 = odd(x[k], p)"),
              "c.net:15: error: p is guarded: no polynomial is of it");
}

TEST(CurveTable, OfCarriedStepsArePlacedAndMoved) {
    const std::string placed = "anchor\n  place[k] : -2 = a[k]";
    const std::string sample = "sample\n  d[k] : -2 = a[k]";
    const std::string move = "  move[k] : -2 = sum(x[k])\n";
    const std::string place = "  place[k] : -2 = a[k]\n";
    EXPECT_EQ(refused(placed, "carry\n" + move + place + sample), "");
    EXPECT_NE(refused(placed, "carry\n" + move + sample).find("it has no place[k]"),
              std::string::npos);
    EXPECT_NE(refused(placed, "carry\n" + place + sample).find("it has no move[k]"),
              std::string::npos);
    EXPECT_NE(refused(placed, "carry\n" + move + place).find("without `sample`"),
              std::string::npos);
}

TEST(CurveTable, OfANetworkAloneIsNoCurve) {
    const std::string text = "curve h y = 1 / t\nstart y 0\nnext\n  y : 0 = 1/2 y";
    EXPECT_TRUE(read_network_text("h.net", text).network());
    try {
        read_curve_text("h.net", text);
        FAIL() << "it draws nothing";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "h.net:1: error: a network alone: it has no `output` to draw");
    }
    const std::pair<const char*, const char*> cases[] = {
        {"curve h\nstart y[3] 0\nnext\n  y[k] : 0 = 1/2 y[k]",
         "h.net:2: error: y is a row of each axis: a network alone has none"},
        {"curve h\nstart y 0\nnext\n  y : 0 = y >> s",
         "h.net:4: error: a network alone has no samples, and no scale s"},
        {"curve h\nstart y 0\nsample\n  q : 0 = y",
         "h.net:4: error: a network alone has no samples, and no scale s"}};
    for (const auto& [lines, reason] : cases) {
        try {
            read_network_text("h.net", lines);
            ADD_FAILURE() << lines;
        } catch (const InputError& error) {
            EXPECT_STREQ(error.what(), reason);
        }
    }
}

/// A board says its table by this number.
TEST(CurveTable, NumbersOfTheShippedOnesDiffer) {
    std::map<std::uint32_t, std::string> names;
    std::size_t tables = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RTL_DIR "/../ref/curves")) {
        if (entry.path().extension() != ".net") continue;
        ++tables;
        const CurveTable table = read_curve_table(entry.path());
        const std::uint32_t number = curvecore_table_number(table.text.c_str());
        EXPECT_TRUE(number >= 1 && number <= CURVECORE_MOST(CORE_TABLE)) << number;
        EXPECT_TRUE(names.emplace(number, table.name).second)
            << table.name << " is " << names[number];
    }
    EXPECT_GT(tables, 5U);
}

TEST(CurveTable, RowsAreNeededAsFarAsTheKernelMakesThem) {
    const CurveTable spline = read_curve_table(std::string(CURVES_DIR) + "/spline.net");
    const auto polynomial = order_demand(spline, 6, true);
    const std::pair<const char*, int> rows[] = {{"q", 6}, {"phi", 5}, {"DV", 5}, {"DP", 5},
                                                {"V", 4}, {"W", 4},   {"Q", 4},  {"R", 3},
                                                {"S", 3}, {"x", 0}};
    for (const auto& [row, order] : rows) {
        const auto found = polynomial.find(row);
        EXPECT_EQ(found == polynomial.end() ? 0 : found->second, order) << row;
    }
    const auto series = order_demand(spline, 6, false);
    EXPECT_EQ(series.at("x"), 6);
    EXPECT_EQ(series.at("V"), 5);
    EXPECT_EQ(series.at("phi"), 5);
}

}  // namespace curvecore::ref::curve_table_test
