// SPDX-License-Identifier: Apache-2.0
// A job drawn by a board, every sample checked.
#pragma once

#include <functional>
#include <optional>

#include "sysc/board/board.hpp"
#include "sysc/watch/check_result.hpp"
#include "sysc/watch/pictures.hpp"
#include "sysc/watch/samples_writer.hpp"

namespace curvecore::sysc {

struct BoardRun {
    const Job& job;
    std::uint64_t samples;
    SamplesWriter& writer;
    Pictures& pictures;
    std::function<void(std::uint64_t samples)> progress;
};

struct BoardResult {
    CheckResult check;
    BoardStatus status;
    double seconds = 0;             // of simulation
    std::uint64_t first_clock = 0;  // that gave a sample
    /// The least sample period that was kept; none: nothing has clocks, or stalls or a timer of the
    /// board's own had the samples wait.
    std::optional<double> period_clocks;
};

/// The board works in this thread, checks and samples.csv in another.
BoardResult run_board(Board& board, const BoardRun& run);

}  // namespace curvecore::sysc
