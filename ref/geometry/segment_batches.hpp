// SPDX-License-Identifier: Apache-2.0
// Moves of any number looked at by their segments, some at a time: in little memory.
#pragma once

#include <string>
#include <utility>

#include "ref/geometry/geometry.hpp"

namespace curvecore::ref {

class SegmentBatches {
  public:
    /// Creates batches for a machine, which must outlive them.
    SegmentBatches(std::string file, const Machine& machine, PlanOptions options)
        : machine_(machine), options_(std::move(options)) {
        batch_.file = std::move(file);
    }

    /// Adds a move. @throws InputError, of it or one of the last: travel, words
    void add(const Move& move) {
        constexpr std::size_t kBatch = 500;
        batch_.moves.push_back(move);
        if (batch_.moves.size() == kBatch) look();
    }
    /// Looks at the moves that were added last. @throws InputError
    void look() {
        segments_ += make_geometry(batch_, machine_, options_).segments.size();
        batch_.moves.clear();
    }
    /// Number of segments of all moves that were looked at.
    std::size_t segments() const { return segments_; }

  private:
    const Machine& machine_;
    PlanOptions options_;
    Program batch_;
    std::size_t segments_ = 0;
};

}  // namespace curvecore::ref
