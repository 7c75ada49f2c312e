// SPDX-License-Identifier: Apache-2.0
// Long moves in parts: a window of the plan has whole moves, and bounded memory.
#pragma once

#include "ref/machine/machine.hpp"
#include "ref/moves/move_source.hpp"

namespace curvecore::ref {

/// Gives the moves of a source; a move that takes more than 200 s at its feed, or an arc that takes
/// more than 10 s at the machine's speed there, in even parts.
class MoveParts {
  public:
    /// @param machine outlives it
    MoveParts(MoveSource source, const Machine& machine)
        : source_(std::move(source)), machine_(machine) {}

    /// Gives the next move; returns false if there is none. @throws InputError of the source
    bool next(Move& move);

  private:
    MoveSource source_;
    const Machine& machine_;
    Move whole_;
    int parts_ = 0;
    int given_ = 0;
};

}  // namespace curvecore::ref
