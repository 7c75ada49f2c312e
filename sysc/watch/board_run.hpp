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
    double seconds = 0;             // of simulation, real time
    std::uint64_t first_clock = 0;  // clock of the first sample
    /// Least sample period that was kept; none: the board has no clocks, or stalls or its own timer
    /// delayed samples.
    std::optional<double> period_clocks;
};

/// Runs the job: the board works in this thread, checks and samples.csv in another.
BoardResult run_board(Board& board, const BoardRun& run);

}  // namespace curvecore::sysc
