// SPDX-License-Identifier: Apache-2.0
// Linear equations whose unknowns meet their next two neighbours only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace curvecore::ref {

/// A symmetric matrix with two bands on each side, and its Cholesky decomposition.
class Banded {
  public:
    explicit Banded(std::size_t n) : band_(n, {0, 0, 0}) {}

    void clear() { std::fill(band_.begin(), band_.end(), std::array<double, 3>{0, 0, 0}); }
    void add(std::size_t i, std::size_t j, double value) {
        if (i >= j) band_[i][i - j] += value;
    }

    /// x with (this) x = b; overwrites both.
    void solve(std::vector<double>& b) {
        const std::size_t n = band_.size();
        for (std::size_t i = 0; i < n; ++i) {  // L D L^T
            auto& row = band_[i];
            if (i > 1) row[2] /= band_[i - 2][0];
            if (i > 0) {
                if (i > 1) row[1] -= row[2] * band_[i - 2][0] * band_[i - 1][1];
                row[1] /= band_[i - 1][0];
                row[0] -= row[1] * row[1] * band_[i - 1][0];
            }
            if (i > 1) row[0] -= row[2] * row[2] * band_[i - 2][0];
            if (!(row[0] > 0)) row[0] = 1e300;  // lost in rounding: this one stays
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (i > 0) b[i] -= band_[i][1] * b[i - 1];
            if (i > 1) b[i] -= band_[i][2] * b[i - 2];
        }
        for (std::size_t i = 0; i < n; ++i) b[i] /= band_[i][0];
        for (std::size_t i = n; i-- > 0;) {
            if (i + 1 < n) b[i] -= band_[i + 1][1] * b[i + 1];
            if (i + 2 < n) b[i] -= band_[i + 2][2] * b[i + 2];
        }
    }

  private:
    std::vector<std::array<double, 3>> band_;  // of row i: columns i, i - 1, i - 2
};

}  // namespace curvecore::ref
