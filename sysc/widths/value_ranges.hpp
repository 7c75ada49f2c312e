// SPDX-License-Identifier: Apache-2.0
// What the words of a network were seen to hold, variable by variable and order by order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "sysc/widths/run_time_words.hpp"

namespace curvecore::sysc {

/// The variables of both networks: hls/spherical_kernel.hpp, hls/spline_network.hpp.
enum class Variable {
    kWeight,     // arcs: theta / i
    kNormal,     // n and its series N
    kTangent,    // t and its series T
    kMove,       // displacement's series, with the advance
    kSine,       // of the angle, polynomial mode
    kVersine,    //
    kParameter,  // splines: v, the state between steps
    kStepA,      // a', 6a'
    kSixA,       //
    kNorm,       // V.V
    kQ,          // q = v in the step
    kW,          //
    kDV,         //
    kV,          //
    kDP,         //
    kDphi,       //
    kPhi,        //
    kS,          //
    kBigQ,       // Q
    kR,          //
    kX,          // series mode
    kCount
};

constexpr std::size_t kVariables = static_cast<std::size_t>(Variable::kCount);

/// Name as the report shows it, and the word's fraction bits: CoefBits + `frac`.
struct VariableFormat {
    const char* name;
    bool spline;
    int frac;
};
const VariableFormat& variable_format(Variable variable);

/// Least and greatest value of one word; empty: low > high.
struct ValueRange {
    RunWord low = std::numeric_limits<RunWord>::max();
    RunWord high = std::numeric_limits<RunWord>::min();

    bool empty() const { return low > high; }
    void add(RunWord value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// Width of the least two's complement word that holds it, 1 for nothing but 0 and -1.
    int bits() const;
};

class ValueRanges {
  public:
    explicit ValueRanges(int coef_bits) : coef_bits_(coef_bits) {}

    /// Notes a value and returns it as the word keeps it.
    RunWord keep(Variable variable, int order, RunWord value) {
        at(variable, order).add(value);
        return wrapped(value, coef_bits_);
    }

    /// The same for a word that the report does not name.
    RunWord keep(RunWord value) {
        unnamed_.add(value);
        return wrapped(value, coef_bits_);
    }

    const ValueRange& range(Variable variable, int order) const {
        return ranges_[static_cast<std::size_t>(variable)][static_cast<std::size_t>(order)];
    }
    int coef_bits() const { return coef_bits_; }
    /// Bits that the worst word lacks; 0 when all hold their values.
    int missing() const;

  private:
    ValueRange& at(Variable variable, int order) {
        return ranges_[static_cast<std::size_t>(variable)][static_cast<std::size_t>(order)];
    }

    int coef_bits_;
    ValueRange unnamed_;
    std::array<std::array<ValueRange, kMostOrders>, kVariables> ranges_;
};

}  // namespace curvecore::sysc
