// SPDX-License-Identifier: Apache-2.0
// A machine that draws a curve from its table (ref/curves/curve_table.hpp), line by line, in any
// arithmetic: in as many digits as a truth needs, or in a core's words.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/curves/placed_table.hpp"

namespace curvecore::ref {

/// Arithmetic that rounds nothing but what Number itself does.
template <class Number>
struct Unrounded {
    /// The value of a row with this fraction.
    Number rounded(const Number& sum, int /*fraction*/) const { return sum; }
    /// 1/i, the weight of order i.
    Number weight(int i) const { return Number(1) / i; }
    /// A position, in length units.
    Number position(const Number& sum) const { return sum; }
    /// Fraction bits that a guarded row has more.
    int guard() const { return 0; }
};

/// Draws a segment step by step. A step is 2^k length units, tau its part that is drawn.
///
/// | quantity      | unit                                                               |
/// |---------------|--------------------------------------------------------------------|
/// | value of a row | as its line says: a word of F fraction bits is value 2^F           |
/// | start, position | length units                                                     |
///
/// Number: double, or a Boost.Multiprecision number without expression templates.
template <class Number, class Arithmetic = Unrounded<Number>>
class TableMachine {
  public:
    using Axes = std::array<Number, 3>;

    /// Orders from 1 on; `polynomial`: the mode of the sampler; `anchored`: the core's Anchor.
    TableMachine(const CurveTable& table, int order, bool polynomial,
                 const Arithmetic& arithmetic = {}, bool anchored = true)
        : table_(table),
          order_(order),
          by_lines_(table.samples_by_lines(polynomial)),
          carries_(table.carries(anchored)),
          arithmetic_(arithmetic),
          lines_(table, order, polynomial, anchored),
          tau_(lines_.row("tau")),
          rows_(lines_.rows()) {
        for (const auto& [name, row] : table.rows) {
            Row& made = rows_[number(name)];
            for (auto& axis : made.at) axis.assign(static_cast<std::size_t>(order) + 1, Number(0));
            if (row.value) made.at[0][0] = Number(*row.value);
        }
        if (!table.network()) {
            output_ = lines_.operand({table.output, true, 0, {}});
            drawn_ = number("d");
        }
    }

    /// Sets a row that comes from the bus.
    void set(const std::string& row, const Number& value, int axis = 0) {
        make(rows_[number(row)], axis, 0, value);
    }

    /// Begins the segment whose words are set, with its first step.
    void load(const Axes& start, int k, int lambda) {
        begin(start, k, lambda);
        open();
    }
    /// The same without the step: open() makes it, of an anchored one.
    void begin(const Axes& start, int k, int lambda) {
        start_ = origin_ = start;
        k_ = k;
        down_ = lambda - k;
        lambda_ = lambda;
        for (const auto& [name, row] : table_.rows) {
            if (row.value) rows_[number(name)].at[0][0] = Number(*row.value);
        }
    }

    /// Goes on to the next step.
    void step() {
        leave();
        if (!carries_) return open();
        lines("carry");
        orders();
    }

    /// Makes what a segment and a step begin with, of the rows that are set and carried.
    void open() {
        lines("load");
        lines("anchor");
        orders();
    }
    /// Makes the orders of a step.
    void orders() {
        const std::vector<PlacedLine>& lines = lines_.section("order");
        for (int i = 1; i <= order_; ++i) {
            for (const PlacedLine& line : lines) {
                if (i >= line.first && i <= line.last) run(line, i);
            }
        }
    }
    /// Carries on what the next step begins with.
    void leave() { lines("next"); }

    /// The positions that the segment and the step begin with.
    const Axes& start() const { return start_; }
    const Axes& origin() const { return origin_; }
    void set_positions(const Axes& start, const Axes& origin) {
        start_ = start;
        origin_ = origin;
    }

    /// The position at tau of the step, 0 <= tau < 1.
    Axes sample(const Number& tau) {
        rows_[static_cast<std::size_t>(tau_)].at[0][0] = tau;
        if (by_lines_) lines("sample");
        Axes at;
        for (int axis = 0; axis < 3; ++axis) {
            at[axis] = moved(origin_[axis],
                             by_lines_ ? rows_[drawn_].at[axis][0]
                                       : horner(output_, axis, tau, output_.fraction, 1, 1),
                             k_);
        }
        return at;
    }

    /// A row's order of the step.
    const Number& value(const std::string& row, int order = 0, int axis = 0) const {
        return rows_[number(row)].at[axis][static_cast<std::size_t>(order)];
    }
    /// The largest magnitude that a row has had, in any order.
    const Number& largest(const std::string& row) const { return rows_[number(row)].largest; }

  private:
    struct Row {
        std::array<std::vector<Number>, 3> at;
        Number largest{0};
    };

    static Number scaled(const Number& value, int power) {
        using std::ldexp;
        return ldexp(value, power);
    }
    Number moved(const Number& from, const Number& by, int power) const {
        return from + arithmetic_.position(scaled(by, power));
    }

    std::size_t number(const std::string& row) const {
        return static_cast<std::size_t>(lines_.row(row));
    }

    void lines(const char* section) {
        for (const PlacedLine& line : lines_.section(section)) {
            run(line, 0);
            if (!line.moves && !line.places) continue;
            const auto& made = rows_[static_cast<std::size_t>(line.row)].at;
            for (int axis = 0; axis < 3; ++axis) {
                origin_[axis] = line.moves ? moved(origin_[axis], made[axis][0], k_)
                                           : moved(start_[axis], made[axis][0], lambda_);
            }
        }
    }

    void run(const PlacedLine& placed, int i) {
        const TableLine& line = *placed.line;
        const auto order = static_cast<std::size_t>(line.order.value_or(i));
        Axes made{};
        const bool axes = line.of_axis || line.adds_axes;
        guarded_ = placed.guarded;
        for (int axis = 0; axis < (axes ? 3 : 1); ++axis) made[axis] = result(placed, i, axis);
        if (line.adds_axes) made[0] += made[1] + made[2];
        Row& row = rows_[static_cast<std::size_t>(placed.row)];
        for (int axis = 0; axis < (line.of_axis ? 3 : 1); ++axis) {
            make(row, axis, order, made[axis]);
        }
    }

    static void make(Row& row, int axis, std::size_t order, const Number& value) {
        using std::abs;
        row.at[axis][order] = value;
        row.largest = std::max(row.largest, Number(abs(value)));
    }

    Number result(const PlacedLine& placed, int i, int axis) {
        using Function = TableLine::Function;
        const TableLine& line = *placed.line;
        Number sum(0);
        for (const PlacedTerm& part : placed.terms) {
            const TableTerm& term = *part.term;
            for (int of = term.all_axes ? 0 : axis; of <= (term.all_axes ? 2 : axis); ++of) {
                sum += scaled(term.number * meet(part, i, of), -term.halvings);
            }
        }
        if (line.function == Function::kSum) {
            for (int order = 1; order <= order_; ++order) sum += entry(placed.series, order, axis);
        } else if (line.function != Function::kTerms) {
            const Number& x = rows_[static_cast<std::size_t>(placed.variable)].at[0][0];
            return horner(
                placed.series, axis, x, line.fraction, line.function == Function::kHorner ? 1 : 2,
                line.function == Function::kEven ? 2 : 1, line.function != Function::kOdd);
        }
        const int fraction = line.fraction + (guarded_ ? arithmetic_.guard() : 0);
        return arithmetic_.rounded(scaled(sum, -line.down * down_), fraction);
    }

    /// The sum of orders last, last + by .. times powers of x, and once more by x.
    Number horner(const PlacedOperand& series, int axis, const Number& x, int fraction, int by,
                  int last, bool times = true) const {
        int i = order_ - (order_ - last) % by;
        Number sum = entry(series, i, axis);
        for (i -= by; i >= last; i -= by) {
            sum = entry(series, i, axis) + arithmetic_.rounded(sum * x, fraction);
        }
        return times ? arithmetic_.rounded(sum * x, fraction) : sum;
    }

    Number meet(const PlacedTerm& part, int i, int axis) const {
        using Meeting = TableTerm::Meeting;
        const Meeting meeting = part.term->meeting;
        if (meeting == Meeting::kConstant) return Number(1);
        if (meeting == Meeting::kAlone) return entry(part.a, i, axis);
        if (meeting == Meeting::kOverOrder) {
            return i > 1 ? entry(part.a, i, axis) * arithmetic_.weight(i) : entry(part.a, i, axis);
        }
        if (i == 0 || !part.meets) return entry(part.a, i, axis) * entry(part.b, i, axis);
        Number sum(0);
        for (int j = 0; j <= (part.integral ? i - 1 : i); ++j) {
            sum += entry(part.a, j, axis) * entry(part.b, i - j, axis);
        }
        return sum;
    }

    /// An order of a row, as the rows before have it; 0 of what no line makes. Of a guarded row
    /// only guarded ones read the bits that it has more.
    Number entry(const PlacedOperand& of, int i, int axis) const {
        const int order = of.series ? of.order.value_or(i) - of.primes : 0;
        if (order < 0 || order > order_) return Number(0);
        const Number& all = rows_[static_cast<std::size_t>(of.row)]
                                .at[of.of_axis ? axis : 0][static_cast<std::size_t>(order)];
        const bool cut = of.guarded && !guarded_ && arithmetic_.guard() != 0;
        return cut ? arithmetic_.rounded(all, of.fraction) : all;
    }

    const CurveTable& table_;
    int order_;
    bool by_lines_;  // samples
    bool carries_;   // Anchor 0
    Arithmetic arithmetic_;
    PlacedTable lines_;
    int tau_;
    std::vector<Row> rows_;
    PlacedOperand output_;
    std::size_t drawn_ = 0;  // d, the place in the step
    Axes start_{};
    Axes origin_{};
    int k_ = 0;
    int lambda_ = 0;
    int down_ = 0;          // s
    bool guarded_ = false;  // the line that is run
};

}  // namespace curvecore::ref
