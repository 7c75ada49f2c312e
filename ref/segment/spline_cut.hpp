// SPDX-License-Identifier: Apache-2.0
// The cut of a cubic, independent of its place on the path: found once and kept, since checks and
// windows need the same cubics again.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "ref/bound/error_bound.hpp"
#include "ref/curve/cubic.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// | field   | unit  | remark                                                     |
/// |---------|-------|------------------------------------------------------------|
/// | pieces  |       | from 0 <= u <= 1 in order; s_start is not set              |
/// | lengths | units | of the pieces, not rounded                                 |
struct SplineCut {
    std::vector<Segment> pieces;
    std::vector<double> lengths;
};
using SharedCut = std::shared_ptr<const SplineCut>;

/// Makes the pieces of split_spline() (ref/segment/spline_segment.hpp), which places them; with a
/// least_last_step(), units, some more of them (ref/segment/last_step.hpp).
/// @throws std::domain_error as split_spline() does
SplineCut cut_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                     const Aux& aux_advance, int max_pieces, double least_last_step = 0);

/// The last cuts, some thousands of them, of one core and limit, for all threads.
class KnownCuts {
  public:
    /// Returns cut_spline() of the same arguments.
    SharedCut of(const Cubic& cubic, const CoreParameters& format, double limit,
                 const Aux& aux_advance, int max_pieces, double least_last_step = 0);

    std::size_t size() const;

  private:
    // The doubles of a cubic, of a rate and of a last step.
    using Key = std::array<std::uint64_t, 13 + kAuxAxes>;
    struct Hash {
        std::size_t operator()(const Key& key) const;
    };
    using Cuts = std::unordered_map<Key, SharedCut, Hash>;

    void use(const CoreParameters& format, double limit, int max_pieces);
    SharedCut known(const Key& key);
    void keep(const Key& key, const SharedCut& cut);

    mutable std::mutex mutex_;
    CoreParameters format_;
    double limit_ = 0;
    int max_pieces_ = 0;
    Cuts recent_;
    std::size_t recent_pieces_ = 0;  // pieces of all of these
    Cuts before_;                    // cuts older than these
};

}  // namespace curvecore::ref
