// SPDX-License-Identifier: Apache-2.0
// Minimum and mean over a sliding window, in linear time.
#pragma once

#include <algorithm>
#include <deque>
#include <vector>

namespace curvecore::ref {

/// The least value within `width` places to both sides.
inline std::vector<double> sliding_least(const std::vector<double>& values, std::size_t width) {
    const std::size_t n = values.size();
    std::vector<double> least(n);
    std::deque<std::size_t> rising;  // places of values that no later value undercuts
    std::size_t next = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (; next < std::min(n, i + width + 1); ++next) {
            while (!rising.empty() && values[rising.back()] >= values[next]) rising.pop_back();
            rising.push_back(next);
        }
        while (rising.front() + width < i) rising.pop_front();
        least[i] = values[rising.front()];
    }
    return least;
}

/// The mean within `width` places to both sides; beyond the ends nothing counts.
inline std::vector<double> sliding_mean(const std::vector<double>& values, std::size_t width) {
    const std::size_t n = values.size();
    std::vector<double> sums{0};
    for (const double value : values) sums.push_back(sums.back() + value);
    std::vector<double> mean(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t first = i > width ? i - width : 0;
        const std::size_t end = std::min(n, i + width + 1);
        mean[i] = (sums[end] - sums[first]) / static_cast<double>(end - first);
    }
    return mean;
}

}  // namespace curvecore::ref
