// SPDX-License-Identifier: Apache-2.0
// Long moves in parts: a window of the plan has whole moves, and bounded memory.
#pragma once

#include "ref/machine/machine.hpp"
#include "ref/moves/move_source.hpp"

namespace curvecore::ref {

constexpr double kLongestPart = 200;  // s: bounds pieces and stop branches in memory

/// Gives the moves of a source; a move that takes longer than a part, or an arc that takes more
/// than 10 s at the machine's speed there, in even parts.
class MoveParts {
  public:
    /// @param machine outlives it
    /// @param longest least time of a part, s
    MoveParts(MoveSource source, const Machine& machine, double longest = kLongestPart)
        : source_(std::move(source)), machine_(machine), longest_(longest) {}

    /// Gives the next move; returns false if there is none. @throws InputError of the source
    bool next(Move& move);

  private:
    MoveSource source_;
    const Machine& machine_;
    double longest_;
    Move whole_;
    int parts_ = 0;
    int given_ = 0;
};

}  // namespace curvecore::ref
