// SPDX-License-Identifier: Apache-2.0
// A table's lines with their rows by number, for one Order, mode and Anchor: what a machine that
// runs them many times reads.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ref/curves/curve_table.hpp"

namespace curvecore::ref {

/// A row as a line reads it, itself and no alias of it.
struct PlacedOperand {
    int row = -1;
    int fraction = 0;
    bool of_axis = false;
    bool series = false;
    bool guarded = false;
    int primes = 0;
    std::optional<int> order;
};

struct PlacedTerm {
    const TableTerm* term = nullptr;
    PlacedOperand a;  // where two series meet, the one that counts up from order 0
    PlacedOperand b;
    bool meets = false;     // over all orders
    bool integral = false;  // as in a Stieltjes integrator
};

struct PlacedLine {
    const TableLine* line = nullptr;
    int row = -1;
    int first = 1;  // order that a line of `order` makes
    int last = 0;   // the highest that is needed
    bool guarded = false;
    bool moves = false;   // the origin
    bool places = false;  // the same from the segment's start
    PlacedOperand series;
    int variable = -1;  // of a polynomial
    std::vector<PlacedTerm> terms;
};

class PlacedTable {
  public:
    /// The table must outlive it. `polynomial`: the mode of the sampler; `anchored`: Anchor.
    PlacedTable(const CurveTable& table, int order, bool polynomial, bool anchored);

    std::size_t rows() const { return numbers_.size(); }
    /// @throws std::out_of_range: there is no such row
    int row(const std::string& name) const { return numbers_.at(name); }
    const std::vector<PlacedLine>& section(const std::string& name) const {
        return sections_.at(name);
    }
    PlacedOperand operand(const RowOperand& of) const;

  private:
    PlacedLine placed(const TableLine& line, bool order,
                      const std::map<std::string, int>& needed) const;
    PlacedTerm placed(const TableTerm& term) const;

    const CurveTable& table_;
    std::map<std::string, int> numbers_;
    std::map<std::string, std::vector<PlacedLine>> sections_;
};

}  // namespace curvecore::ref
