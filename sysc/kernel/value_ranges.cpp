// SPDX-License-Identifier: Apache-2.0
#include "sysc/kernel/value_ranges.hpp"

namespace curvecore::sysc {

int ValueRange::bits() const {
    const auto magnitude = static_cast<std::uint64_t>(std::max(high, ~low));
    int bits = 1;
    while (bits < 64 && magnitude >> (bits - 1) != 0) ++bits;
    return bits;
}

int ValueRanges::first_row(const std::string& curve, const hls::WordRow* rows) {
    const auto known = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const RowRanges& of) { return of.curve == curve; });
    const auto first = static_cast<int>(known - rows_.begin());
    if (known != rows_.end()) return first;
    for (; rows->name != nullptr; ++rows) rows_.push_back({curve, rows->name, rows->fraction});
    return first;
}

int ValueRanges::missing() const {
    int most = 0;
    for (const RowRanges& row : rows_) {
        for (const ValueRange& range : row.orders) {
            if (!range.empty()) most = std::max(most, range.bits() - coef_bits_);
        }
    }
    return most;
}

}  // namespace curvecore::sysc
