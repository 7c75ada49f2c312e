// SPDX-License-Identifier: Apache-2.0
// Ranges of values that the words of a network held, variable by variable and order by order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "hls/variables.hpp"

namespace curvecore::sysc {

using hls::Variable;
constexpr std::size_t kVariables = static_cast<std::size_t>(Variable::kCount);

/// Name in the report, and the word's fraction bits: CoefBits + `frac`.
struct VariableFormat {
    const char* name;
    bool spline;
    int frac;
};
const VariableFormat& variable_format(Variable variable);

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

class ValueRanges {
  public:
    explicit ValueRanges(int coef_bits) : coef_bits_(coef_bits) {}

    /// Notes a value and returns it as the word keeps it: bits beyond the width are cut off.
    std::int64_t keep(Variable variable, int order, std::int64_t value) {
        at(variable, order).add(value);
        const int left = 64 - coef_bits_;
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << left) >> left;
    }

    const ValueRange& range(Variable variable, int order) const {
        return ranges_[static_cast<std::size_t>(variable)][static_cast<std::size_t>(order)];
    }
    int coef_bits() const { return coef_bits_; }
    /// Number of bits that the worst word lacks; 0 when all hold their values.
    int missing() const;

  private:
    ValueRange& at(Variable variable, int order) {
        return ranges_[static_cast<std::size_t>(variable)][static_cast<std::size_t>(order)];
    }

    int coef_bits_;
    std::array<std::array<ValueRange, hls::kMostOrder + 1>, kVariables> ranges_;
};

}  // namespace curvecore::sysc
