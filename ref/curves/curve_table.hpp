// SPDX-License-Identifier: Apache-2.0
// A curve as a table of lines, one rounding each. What is compiled or run from it has no other
// source: microcode of the engine (rtl/engine/assembler/), and whatever else draws the curve.
//
//     line     ROW : FRACTION = TERM + TERM ..      rounded once, to nearest, ties upwards
//     rows     a, a[k] for each axis, a.2 of order 2, a' of the order before; D.. rates, i x_i
//     terms    a   - 3 a   1/2 a   a*b   a@b   a/i   1   V[*]*V[*] over the axes   a >> 2s
//
// Fractions are counted from CoefBits: -2 has CoefBits - 2 fraction bits. A row has one fraction.
// A line of [k] stands for three. `+=` adds the rounded lines of the three axes.
//
// Series: a line in `order` makes order i of its row. There a series meets a rate as in a Stieltjes
// integrator, the sum of u_j Ds_{i-j}, j < i; two series meet as factors, j <= i; with @ they meet
// order by order. sum(a) adds orders 1 and up, horner(a) is a polynomial in tau, odd(a, x) and
// even(a, x) are those of the odd and even orders in x.
//
//     sections   load    once per segment
//                anchor  first in every step: order 0, or an order that is named
//                order   then order by order, as far as each row is needed
//                next    from step to step
//                carry   with Anchor 0, in place of `anchor`, in every step but the first
//                sample  d[k] of the polynomial mode; in series mode horner(OUTPUT[k])
//
// move[k] is what a step moves the origin by, in units of 2^k; place[k] where the origin lies from
// the segment's start, in units of 2^lambda; s = lambda - k. In `carry` a step whose samples are of
// the series is moved, one whose samples are of lines is placed.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// Row of a table as a line reads it.
struct RowOperand {
    std::string row;
    bool of_axis = false;      // [k], and [*] in a sum over the axes
    int primes = 0;            // of order i - primes
    std::optional<int> order;  // an order that is named
};

/// One part of a sum: number * 2^-halvings * a * b.
struct TableTerm {
    enum class Meeting { kConstant, kAlone, kProduct, kOrderByOrder, kOverOrder };

    Meeting meeting = Meeting::kAlone;
    int number = 1;
    int halvings = 0;
    RowOperand a;
    RowOperand b;
    bool all_axes = false;  // sum over [*]
};

struct TableLine {
    enum class Function { kTerms, kSum, kHorner, kOdd, kEven };

    std::string text;
    int number = 0;  // of the file
    std::string row;
    bool of_axis = false;
    std::optional<int> order;  // of the row, where `anchor` names it
    int fraction = 0;
    bool adds_axes = false;  // +=
    int down = 0;            // >> down s
    Function function = Function::kTerms;
    RowOperand series;             // of the function
    std::string variable;          // of odd and even
    std::vector<TableTerm> terms;  // with a function: added to it
};

struct CurveRow {
    int fraction = 0;
    bool of_axis = false;
    bool word = false;            // fixed in a segment, from the bus
    bool start = false;           // carried from step to step
    bool series = false;          // has orders
    bool polished = false;        // carried, but the anchor squares its error: needs an order less
    std::optional<double> value;  // of a constant, or at a segment's start
    std::optional<RowOperand> same_as = {};  // a rate that is another row
    int line = 0;                            // of the file

    /// Magnitude that is too large for its words, of any CoefBits.
    double range() const { return std::ldexp(1.0, -1 - fraction); }
    bool rate(const std::string& name) const { return series && name[0] == 'D'; }
};

/// Most words of a segment that are of its table alone.
constexpr int kMostFurther = 16;

/// A place of the bus: theta; tangent, normal or advance, words of three axes; or further.N, a word
/// of the table alone, and of a row of three axes also the two behind it.
struct BusPlace {
    std::string field;
    int number = 0;  // of a further word
    bool further() const { return field == "further"; }
};

inline BusPlace bus_place(const std::string& name) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return {name};
    return {name.substr(0, dot), std::stoi(name.substr(dot + 1))};
}

struct CurveTable {
    std::string file;
    std::string text;  // its lines, without remarks
    std::string name;
    std::string title;
    std::string output;
    std::map<std::string, CurveRow> rows;
    std::map<std::string, std::string> bus;  // row by its place of the bus
    std::set<std::string> guarded;           // rows with ParameterGuard fraction bits more
    std::map<std::string, std::vector<TableLine>> sections;
    std::map<std::string, int> said_powers;  // of rows whose power no line says
    std::map<std::string, int> powers = {};  // row_powers(), of a table that programs name

    /// Returns whether it draws nothing: its words are all that there is.
    bool network() const { return bus.empty() && output.empty(); }
    /// Words of a segment that are of the table alone.
    int further_words() const {
        int count = 0;
        for (const auto& [place, row] : bus) {
            const BusPlace at = bus_place(place);
            const int own = rows.at(row).of_axis ? 3 : 1;
            if (at.further()) count = std::max(count, at.number + own);
        }
        return count;
    }
    const std::vector<TableLine>& section(const std::string& of) const {
        static const std::vector<TableLine> kNone;
        const auto found = sections.find(of);
        return found == sections.end() ? kNone : found->second;
    }
    /// Returns whether steps carry their rows where the core's Anchor says so.
    bool carries(bool anchored) const { return !anchored && !section("carry").empty(); }
    /// Returns whether samples are drawn by lines of `sample`; else by the series of the output.
    bool samples_by_lines(bool polynomial) const {
        return polynomial && !section("sample").empty();
    }
};

/// Lets a core draw a table, or none.
inline void add_table(std::shared_ptr<const CurveTable> table, CoreParameters& core) {
    core.further_words = table ? table->further_words() : 0;
    core.table = std::move(table);
}

}  // namespace curvecore::ref
