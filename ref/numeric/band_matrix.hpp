// SPDX-License-Identifier: Apache-2.0
// Linear equations whose unknowns are coupled to their next few neighbours only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace curvecore::ref {

/// A symmetric positive definite matrix with kBands bands on each side: L D L^T in place.
template <std::size_t kBands>
class BandMatrix {
  public:
    explicit BandMatrix(std::size_t n) : row_(n) {}

    void clear() { std::fill(row_.begin(), row_.end(), std::array<double, kBands + 1>{}); }
    /// Adds to element (i, j); an element above the diagonal is left to its mirror.
    void add(std::size_t i, std::size_t j, double value) {
        if (i >= j) row_[i][i - j] += value;
    }

    void decompose() {
        for (std::size_t i = 0; i < row_.size(); ++i) {
            auto& row = row_[i];
            for (std::size_t band = std::min(i, kBands); band > 0; --band) {
                const std::size_t j = i - band;
                double sum = row[band];
                for (std::size_t k = band + 1; k <= std::min(i, kBands) && k - band <= kBands;
                     ++k) {
                    sum -= row[k] * row_[j][k - band];
                }
                row[band] = sum;  // L_ij D_j
            }
            double sum = row[0];
            for (std::size_t band = 1; band <= std::min(i, kBands); ++band) {
                const double product = row[band];
                row[band] /= row_[i - band][0];
                sum -= row[band] * product;
            }
            row[0] = sum > 0 ? sum : 1e300;  // lost in rounding: this unknown stays
        }
    }

    /// Solves (this) x = b, x in b's place; after decompose().
    void solve(std::vector<double>& b) const {
        for (std::size_t i = 0; i < row_.size(); ++i) {
            for (std::size_t k = 1; k <= std::min(i, kBands); ++k) b[i] -= row_[i][k] * b[i - k];
        }
        for (std::size_t i = 0; i < row_.size(); ++i) b[i] /= row_[i][0];
        for (std::size_t i = row_.size(); i-- > 0;) {
            for (std::size_t k = 1; k <= std::min(i, kBands); ++k) b[i - k] -= row_[i][k] * b[i];
        }
    }

  private:
    std::vector<std::array<double, kBands + 1>> row_;  // row i has columns i, i - 1, ..
};

}  // namespace curvecore::ref
