// SPDX-License-Identifier: Apache-2.0
// Seeded segments of splines within the words' ranges: pieces of the planner, cut to a few steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hls/quantise.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/widths/spline_families.hpp"

namespace curvecore::tb {

using namespace sysc;

/// The cubic as words of fewer position bits can hold it.
template <class C>
ref::Cubic in_range(ref::Cubic cubic, double most) {
    cubic.d *= std::ldexp(1.0, C::kPositionBits - 32);
    const auto leaves = [&] {
        double reach = 0;
        for (double u = 0; u <= 1; u += 1.0 / 64) {
            reach = std::max(reach, cubic.position(u).cwiseAbs().maxCoeff());
        }
        return reach > most;
    };
    while (leaves()) {
        cubic.a /= 2;
        cubic.b /= 2;
        cubic.c /= 2;
    }
    return cubic;
}

/// The first dozen of pieces that the planner makes of a cubic of each family.
template <class C>
std::vector<hls::SegmentWords<C>> spline_pieces(std::uint64_t seed) {
    ref::WordFormat format;
    format.order = C::kOrder;
    format.coef_bits = C::kCoefBits;
    format.position_bits = C::kPositionBits;
    format.guard_bits = C::kGuardBits;
    // Coarse words and low orders would take very many pieces.
    const double limit =
        std::max(std::ldexp(0.1, std::max(0, 36 - C::kCoefBits) + (C::kOrder < 4 ? 10 : 0)),
                 std::ldexp(4.0, -C::kGuardBits));
    const double most = std::ldexp(0.9, C::kPositionBits - 1);
    std::vector<hls::SegmentWords<C>> pieces;
    SplineMaker maker(seed);
    for (const SplineFamily& family : spline_families()) {
        int taken = 0;
        const ref::Cubic cubic = in_range<C>(maker.next(family), most);
        for (const ref::Segment& piece : ref::split_spline(cubic, format, limit)) {
            const double reach =
                std::max(piece.start.cwiseAbs().maxCoeff(), piece.end.cwiseAbs().maxCoeff());
            if (reach > most || piece.kind != ref::Segment::Kind::kSpline) continue;
            if (++taken <= 12) pieces.push_back(hls::to_words<C>(piece));
        }
    }
    return pieces;
}

template <class C>
class SplineSegments {
  public:
    using Words = hls::SegmentWords<C>;

    explicit SplineSegments(std::uint64_t seed) : pieces_(spline_pieces<C>(seed)), random_(seed) {}

    /// Any of them, up to six steps of it; one in twelve has no length.
    Words next() {
        Words words = pieces_[random_() % pieces_.size()];
        const std::int64_t longest =
            std::min<std::int64_t>(words.length, std::int64_t{6} << (words.step_exponent + 16));
        words.length =
            1 + static_cast<std::int64_t>(random_() % static_cast<unsigned long>(longest));
        if (random_() % 12 == 0) words.length = 0;
        return with_auxiliary(words);
    }

    /// The one of most steps among those of 2^k units or more, that many whole steps of it at most.
    Words whole(int k, int steps) {
        const auto count = [](const Words& words) {
            return words.length >> (words.step_exponent + 16);
        };
        Words words;
        for (const Words& piece : pieces_) {
            if (piece.step_exponent >= k && count(piece) >= count(words)) words = piece;
        }
        words.length = std::min<std::int64_t>(count(words), steps) << (words.step_exponent + 16);
        return with_auxiliary(words);
    }

  private:
    Words with_auxiliary(Words words) {
        const auto some = [&](int bits) {
            return static_cast<std::int64_t>(random_() >> (65 - bits)) -
                   (std::int64_t{1} << (bits - 2));
        };
        for (int axis = 3; axis < C::kAxes; ++axis) {
            words.start[axis] = some(C::kFineBits - 1);
            words.end[axis] = some(C::kFineBits - 1);
            words.advance[axis] = some(C::kCoefBits - 1);
        }
        return words;
    }

    std::vector<Words> pieces_;
    std::mt19937_64 random_;
};

}  // namespace curvecore::tb
