// SPDX-License-Identifier: Apache-2.0
// One line of a table as steps: sums of products with one rounding.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/compiler/step_writer.hpp"

namespace curvecore::assembler {

class LineLowering {
  public:
    LineLowering(const ref::CurveTable& table, const ref::CoreParameters& core,
                 const std::map<std::string, int>& demand, StepWriter& writer);

    /// Writes a line, in `order` that of order i; returns the value that it makes.
    int lower(const ref::TableLine& line, int i = 0);

    /// Writes a line once more, to another value that has its name from then on.
    void lower_anew(const ref::TableLine& line, int i);

    /// Returns the value of a row, of a series that of order 0; `word`: its word.
    int state(const std::string& row, const std::string& word = "");
    int constant(double value, int fraction);

    /// Writes to = round(a * b / 2^shift).
    void product(int to, int a, int b, int shift, bool of_axis);
    /// Writes to = from + a displacement as a fine word, by a word of scale_word.
    void move(int to, int from, int displacement, const char* scale);

  private:
    /// An addend: number * a * b / 2^shift; without b number * a / 2^shift.
    struct Addend {
        int a = -1;
        int b = -1;
        std::int64_t number = 1;
        int shift = 0;
        bool all_axes = false;
        int over = 0;  // of 1/i, i

        bool exact() const { return b < 0 && shift <= 0; }
    };

    int entry(const ref::RowOperand& operand, int i);
    int entry_of(const std::string& row, int i);
    int fraction(const ref::RowOperand& of) const { return table_.rows.at(of.row).fraction; }
    void addends(const ref::TableLine& line, const ref::TableTerm& term, int i,
                 std::vector<Addend>& all);
    Addend meet(const ref::TableLine& line, const ref::TableTerm& term, int a, int b) const;
    int single(const Addend& one, bool of_axis, int to);
    int chain(const std::vector<Addend>& all, bool of_axis, int to);
    void total(int to, bool of_axis, const std::vector<Addend>& exact, int rounded);
    int exactly(const Addend& one);
    void scaled_down(const ref::TableLine& line, int to);
    int polynomial(const ref::TableLine& line, bool of_axis, int to);
    int sum(const ref::TableLine& line, bool of_axis, int to);

    const ref::CurveTable& table_;
    const ref::CoreParameters& core_;
    const std::map<std::string, int>& demand_;
    StepWriter& writer_;
    std::map<std::string, int> reads_;  // of rows, by lines
    std::map<int, int> same_;           // values that are others
    std::map<int, std::string> row_of_;
};

}  // namespace curvecore::assembler
