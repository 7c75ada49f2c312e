// SPDX-License-Identifier: Apache-2.0
// Ranges of values that the words of a curve's table held, row by row and order by order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "hls/configuration.hpp"

namespace curvecore::sysc {

/// Least and greatest value of one word; empty: low > high.
struct ValueRange {
    std::int64_t low = std::numeric_limits<std::int64_t>::max();
    std::int64_t high = std::numeric_limits<std::int64_t>::min();

    bool empty() const { return low > high; }
    void add(std::int64_t value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// Width of the least two's complement word that holds the range, 1 for only 0 and -1.
    int bits() const;
};

/// A row of a table, and the ranges of its orders.
struct RowRanges {
    std::string curve;
    std::string row;
    int fraction = 0;  // fraction bits of its words: CoefBits and so many
    std::array<ValueRange, hls::kMostOrder + 1> orders{};
};

class ValueRanges {
  public:
    explicit ValueRanges(int coef_bits) : coef_bits_(coef_bits) {}

    /// Number of the first row of a curve's table; the others follow. `rows` end without a name.
    int first_row(const std::string& curve, const hls::WordRow* rows);

    void note(int row, int order, std::int64_t value) {
        rows_[static_cast<std::size_t>(row)].orders[static_cast<std::size_t>(order)].add(value);
    }

    const std::vector<RowRanges>& rows() const { return rows_; }
    int coef_bits() const { return coef_bits_; }
    /// Number of bits that the worst word lacks; 0 when all hold their values.
    int missing() const;

  private:
    int coef_bits_;
    std::vector<RowRanges> rows_;
};

}  // namespace curvecore::sysc
