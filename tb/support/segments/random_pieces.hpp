// SPDX-License-Identifier: Apache-2.0
// Profile pieces for tests: each moves monotonically from 0 to its ds.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hls/words.hpp"

namespace curvecore::tb {

/// A piece that moves ds quanta in `ticks` ticks and begins at `v0` (0 .. 1.9) of its mean speed.
inline hls::ProfileWords piece_of(int64_t ds, int32_t ticks, double v0, bool final) {
    hls::ProfileWords piece;
    piece.ticks = ticks;
    while ((1 << piece.time_exponent) < ticks) ++piece.time_exponent;
    piece.ds = ds;
    piece.final = final;
    const double stretch = std::ldexp(1.0, piece.time_exponent) / ticks;
    const auto total = static_cast<double>(ds);
    const double c[3] = {total * v0 * stretch, total * (1 - v0) * 1.2 * stretch * stretch,
                         total * (1 - v0) * -0.2 * stretch * stretch * stretch};
    // Horner's partial sums stay below 2 as well.
    const double largest = std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2]);
    while (std::ldexp(1.9, piece.exponent) < largest) ++piece.exponent;
    for (int i = 0; i < 3; ++i) {
        piece.c[i] = std::llround(std::ldexp(c[i], hls::kProfileFrac - piece.exponent));
    }
    return piece;
}

/// A program of pieces of 1 .. max_ticks ticks; the last one is final.
inline std::vector<hls::ProfileWords> random_pieces(uint32_t seed, int count, int max_ticks) {
    std::mt19937_64 random(seed);
    std::vector<hls::ProfileWords> pieces;
    for (int n = 0; n < count; ++n) {
        const auto ds = static_cast<int64_t>(random() >> (24 + random() % 40));
        const int ticks = 1 + static_cast<int>(random() % max_ticks);
        const double v0 = 1e-3 * static_cast<double>(random() % 1900);
        pieces.push_back(piece_of(ds, ticks, v0, n == count - 1));
    }
    return pieces;
}

}  // namespace curvecore::tb
