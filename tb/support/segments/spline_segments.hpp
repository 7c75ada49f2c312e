// SPDX-License-Identifier: Apache-2.0
// Seeded segments of splines within the words' ranges: pieces of the planner, cut to a few steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hls/quantise.hpp"
#include "ref/segment/spline_segment.hpp"
#include "sysc/curves/spline_families.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb {

using namespace sysc;

/// Scales the cubic to fit words of fewer position bits.
inline ref::Cubic in_range(ref::Cubic cubic, int position_bits, double most) {
    cubic.d *= std::ldexp(1.0, position_bits - 32);
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

/// The first dozen pieces that the planner makes of a cubic of each family.
inline std::vector<RunSegment> spline_pieces(const CoreParameters& core, std::uint64_t seed) {
    ref::CoreParameters format;
    format.order = core.order;
    format.coef_bits = core.coef_bits;
    format.position_bits = core.position_bits;
    format.guard_bits = core.guard_bits;
    // Coarse words and low orders would take very many pieces.
    const double limit =
        std::max(std::ldexp(0.1, std::max(0, 36 - core.coef_bits) + (core.order < 4 ? 10 : 0)),
                 std::ldexp(4.0, -core.guard_bits));
    const double most = std::ldexp(0.9, core.position_bits - 1);
    std::vector<RunSegment> pieces;
    const RunTimeFormat words(core, core.axes());
    SplineMaker maker(seed);
    for (const SplineFamily& family : spline_families()) {
        int taken = 0;
        const ref::Cubic cubic = in_range(maker.next(family), core.position_bits, most);
        for (const ref::Segment& piece : ref::split_spline(cubic, format, limit)) {
            const double reach =
                std::max(piece.start.cwiseAbs().maxCoeff(), piece.end.cwiseAbs().maxCoeff());
            if (reach > most || piece.kind() != ref::CurveKind::kSpline) continue;
            if (++taken <= 12) pieces.push_back(hls::to_words(piece, words));
        }
    }
    return pieces;
}

class SplineSegments {
  public:
    SplineSegments(const CoreParameters& core, std::uint64_t seed)
        : core_(core), pieces_(spline_pieces(core, seed)), random_(seed) {}

    /// A random piece, up to six steps of it; one in twelve has no length.
    RunSegment next() {
        RunSegment words = pieces_[random_() % pieces_.size()];
        const std::int64_t longest =
            std::min<std::int64_t>(words.length, std::int64_t{6} << (words.step_exponent + 16));
        words.length =
            1 + static_cast<std::int64_t>(random_() % static_cast<unsigned long>(longest));
        if (random_() % 12 == 0) words.length = 0;
        return with_auxiliary(words);
    }

    /// The piece with the most steps of at least 2^k units, cut to at most `steps` whole steps.
    RunSegment whole(int k, int steps) {
        const auto count = [](const RunSegment& words) {
            return words.length >> (words.step_exponent + 16);
        };
        RunSegment words;
        for (const RunSegment& piece : pieces_) {
            if (piece.step_exponent >= k && count(piece) >= count(words)) words = piece;
        }
        words.length = std::min<std::int64_t>(count(words), steps) << (words.step_exponent + 16);
        return with_auxiliary(words);
    }

  private:
    RunSegment with_auxiliary(RunSegment words) {
        const auto some = [&](int bits) {
            return static_cast<std::int64_t>(random_() >> (65 - bits)) -
                   (std::int64_t{1} << (bits - 2));
        };
        for (int axis = 3; axis < core_.axes(); ++axis) {
            words.start[axis] = some(core_.position_bits + core_.guard_bits - 1);
            words.end[axis] = some(core_.position_bits + core_.guard_bits - 1);
            words.advance[axis] = some(core_.coef_bits - 1);
        }
        return words;
    }

    CoreParameters core_;
    std::vector<RunSegment> pieces_;
    std::mt19937_64 random_;
};

}  // namespace curvecore::tb
