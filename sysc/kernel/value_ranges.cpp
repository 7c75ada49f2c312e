// SPDX-License-Identifier: Apache-2.0
#include "sysc/kernel/value_ranges.hpp"

namespace curvecore::sysc {

const VariableFormat& variable_format(Variable variable) {
    static constexpr std::array<VariableFormat, kVariables> kFormats{{
        {"theta/i", false, -1}, {"n, N", false, -2},    {"t, T", false, -2}, {"d", false, -2},
        {"sine", false, -2},    {"versine", false, -2}, {"v", true, -1},     {"a'", true, -1},
        {"6a'", true, 1},       {"B, M", true, -2},     {"|V|^2", true, -1}, {"q", true, -2},
        {"W", true, 1},         {"DV", true, 1},        {"V", true, -1},     {"DP", true, 1},
        {"Dphi", true, 0},      {"phi", true, -2},      {"S", true, -3},     {"Q", true, -4},
        {"R", true, -5},        {"x", true, -2},
    }};
    return kFormats[static_cast<std::size_t>(variable)];
}

int ValueRange::bits() const {
    const auto magnitude = static_cast<std::uint64_t>(std::max(high, ~low));
    int bits = 1;
    while (bits < 64 && magnitude >> (bits - 1) != 0) ++bits;
    return bits;
}

int ValueRanges::missing() const {
    int most = 0;
    for (const auto& orders : ranges_) {
        for (const ValueRange& range : orders) {
            if (!range.empty()) most = std::max(most, range.bits() - coef_bits_);
        }
    }
    return most;
}

}  // namespace curvecore::sysc
