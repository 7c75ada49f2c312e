// SPDX-License-Identifier: Apache-2.0
// A machine that draws a curve from its table (ref/curves/curve_table.hpp), line by line, in any
// arithmetic: in as many digits as a truth needs, or in a core's words.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/curves/order_demand.hpp"

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
          demand_(order_demand(table, order, polynomial, anchored)) {
        for (const auto& [name, row] : table.rows) {
            Row& made = rows_[name];
            for (auto& axis : made.at) axis.assign(static_cast<std::size_t>(order) + 1, Number(0));
            if (row.value) made.at[0][0] = Number(*row.value);
        }
    }

    /// Sets a row that comes from the bus.
    void set(const std::string& row, const Number& value, int axis = 0) {
        make(rows_.at(row), axis, 0, value);
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
            if (row.value) rows_.at(name).at[0][0] = Number(*row.value);
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
        for (int i = 1; i <= order_; ++i) {
            for (const TableLine& line : table_.section("order")) {
                const auto needed = demand_.find(line.row);
                if (needed == demand_.end() || i > needed->second) continue;
                if (i > 1 || !begun(line.row)) run(line, i);
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
        rows_.at("tau").at[0][0] = tau;
        if (!by_lines_) {
            Axes at;
            const int fraction = table_.rows.at(table_.output).fraction;
            for (int axis = 0; axis < 3; ++axis) {
                RowOperand output{table_.output, true, 0, {}};
                at[axis] = moved(origin_[axis], horner(output, axis, tau, fraction, 1, 1), k_);
            }
            return at;
        }
        lines("sample");
        Axes at;
        for (int axis = 0; axis < 3; ++axis) {
            at[axis] = moved(origin_[axis], rows_.at("d").at[axis][0], k_);
        }
        return at;
    }

    /// A row's order of the step.
    const Number& value(const std::string& row, int order = 0, int axis = 0) const {
        return rows_.at(row).at[axis][static_cast<std::size_t>(order)];
    }
    /// The largest magnitude that a row has had, in any order.
    const Number& largest(const std::string& row) const { return rows_.at(row).largest; }

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

    /// Returns whether the anchor gives order 1 of a row.
    bool begun(const std::string& row) const {
        const auto& anchor = table_.section("anchor");
        return std::any_of(anchor.begin(), anchor.end(), [&](const TableLine& line) {
            return line.row == row && line.order.value_or(0) == 1;
        });
    }

    void lines(const std::string& section) {
        for (const TableLine& line : table_.section(section)) {
            if (section == "carry" && line.row == (by_lines_ ? "move" : "place")) continue;
            run(line, 0);
            const auto& made = rows_.at(line.row).at;
            for (int axis = 0; axis < 3; ++axis) {
                if (line.row == "move") origin_[axis] = moved(origin_[axis], made[axis][0], k_);
                if (line.row == "place")
                    origin_[axis] = moved(start_[axis], made[axis][0], lambda_);
            }
        }
    }

    void run(const TableLine& line, int i) {
        if (line.order.value_or(i) > order_) return;
        Row& row = rows_.at(line.row);
        const auto order = static_cast<std::size_t>(line.order.value_or(i));
        Axes made{};
        const bool axes = line.of_axis || line.adds_axes;
        guarded_ = table_.guarded.count(line.row) != 0;
        for (int axis = 0; axis < (axes ? 3 : 1); ++axis) made[axis] = result(line, i, axis);
        if (line.adds_axes) made[0] += made[1] + made[2];
        for (int axis = 0; axis < (line.of_axis ? 3 : 1); ++axis) {
            make(row, axis, order, made[axis]);
        }
    }

    static void make(Row& row, int axis, std::size_t order, const Number& value) {
        using std::abs;
        row.at[axis][order] = value;
        row.largest = std::max(row.largest, Number(abs(value)));
    }

    Number result(const TableLine& line, int i, int axis) {
        using Function = TableLine::Function;
        Number sum(0);
        for (const TableTerm& term : line.terms) {
            for (int of = term.all_axes ? 0 : axis; of <= (term.all_axes ? 2 : axis); ++of) {
                sum += scaled(term.number * meet(term, i, of), -term.halvings);
            }
        }
        if (line.function == Function::kSum) {
            for (int order = 1; order <= order_; ++order) sum += entry(line.series, order, axis);
        } else if (line.function != Function::kTerms) {
            const bool horner_of_tau = line.function == Function::kHorner;
            const Number& x = value(horner_of_tau ? "tau" : line.variable);
            return horner(line.series, axis, x, line.fraction, horner_of_tau ? 1 : 2,
                          line.function == Function::kEven ? 2 : 1,
                          line.function != Function::kOdd);
        }
        const int fraction = line.fraction + (guarded_ ? arithmetic_.guard() : 0);
        return arithmetic_.rounded(scaled(sum, -line.down * down_), fraction);
    }

    /// The sum of orders last, last + by .. times powers of x, and once more by x.
    Number horner(const RowOperand& series, int axis, const Number& x, int fraction, int by,
                  int last, bool times = true) const {
        int i = order_ - (order_ - last) % by;
        Number sum = entry(series, i, axis);
        for (i -= by; i >= last; i -= by) {
            sum = entry(series, i, axis) + arithmetic_.rounded(sum * x, fraction);
        }
        return times ? arithmetic_.rounded(sum * x, fraction) : sum;
    }

    Number meet(const TableTerm& term, int i, int axis) const {
        using Meeting = TableTerm::Meeting;
        if (term.meeting == Meeting::kConstant) return Number(1);
        if (term.meeting == Meeting::kAlone) return entry(term.a, i, axis);
        if (term.meeting == Meeting::kOverOrder) {
            return i > 1 ? entry(term.a, i, axis) * arithmetic_.weight(i) : entry(term.a, i, axis);
        }
        if (i == 0 || !meet_as_series(table_, term)) {
            return entry(term.a, i, axis) * entry(term.b, i, axis);
        }
        const bool rate_a = table_.rows.at(term.a.row).rate(term.a.row);
        const bool rate_b = table_.rows.at(term.b.row).rate(term.b.row);
        const RowOperand& ordered = rate_a && !rate_b ? term.b : term.a;
        const RowOperand& other = rate_a && !rate_b ? term.a : term.b;
        Number sum(0);
        for (int j = 0; j <= (rate_a || rate_b ? i - 1 : i); ++j) {
            sum += entry(ordered, j, axis) * entry(other, i - j, axis);
        }
        return sum;
    }

    /// An order of a row, as the rows before have it; 0 of what no line makes. Of a guarded row
    /// only guarded ones read the bits that it has more.
    Number entry(const RowOperand& operand, int i, int axis) const {
        const RowOperand of = same_row(table_, operand);
        const CurveRow& row = table_.rows.at(of.row);
        const int order = row.series ? of.order.value_or(i) - of.primes : 0;
        if (order < 0 || order > order_) return Number(0);
        const Number& all = value(of.row, order, row.of_axis ? axis : 0);
        const bool cut = arithmetic_.guard() != 0 && !guarded_ && table_.guarded.count(of.row) != 0;
        return cut ? arithmetic_.rounded(all, row.fraction) : all;
    }

    const CurveTable& table_;
    int order_;
    bool by_lines_;  // samples
    bool carries_;   // Anchor 0
    Arithmetic arithmetic_;
    std::map<std::string, int> demand_;
    std::map<std::string, Row> rows_;
    Axes start_{};
    Axes origin_{};
    int k_ = 0;
    int lambda_ = 0;
    int down_ = 0;          // s
    bool guarded_ = false;  // the line that is run
};

}  // namespace curvecore::ref
