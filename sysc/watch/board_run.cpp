// SPDX-License-Identifier: Apache-2.0
#include "sysc/watch/board_run.hpp"

#include <chrono>
#include <exception>
#include <thread>

#include "sysc/board/channel.hpp"
#include "sysc/board/feeder.hpp"
#include "sysc/watch/checker.hpp"
#include "sysc/watch/measured_pace.hpp"

namespace curvecore::sysc {
namespace {

using Batch = std::vector<Sample>;
constexpr std::size_t kBatch = 4096;  // samples passed between the threads at once

/// Feeds the board to its last sample, or until the other end closes the channel.
void draw(Board& board, const BoardRun& run, Channel<Batch>& channel) {
    Feeder feeder(run.job, run.samples, board);
    std::uint64_t drawn = 0;
    bool open = true;
    while (open && !feeder.done()) {
        Batch batch;
        batch.reserve(kBatch);
        while (batch.size() < kBatch && !feeder.done()) feeder.turn(batch);
        drawn += batch.size();
        open = channel.push(std::move(batch));
        run.progress(drawn);
    }
}

}  // namespace

BoardResult run_board(Board& board, const BoardRun& run) {
    Checker checker(run.job, run.writer, run.pictures);
    MeasuredPace pace(run.job);
    Channel<Batch> channel(16);
    std::exception_ptr check_failure;
    std::thread check([&] {
        try {
            while (const auto batch = channel.pop()) {
                for (const Sample& sample : *batch) {
                    checker.take(sample);
                    pace.take(sample);
                }
            }
        } catch (...) {
            check_failure = std::current_exception();
            channel.close();
        }
    });
    const auto begin = std::chrono::steady_clock::now();
    std::exception_ptr board_failure;
    try {
        draw(board, run, channel);
    } catch (...) {
        board_failure = std::current_exception();
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    channel.close();
    check.join();
    if (check_failure) std::rethrow_exception(check_failure);
    if (board_failure) std::rethrow_exception(board_failure);
    BoardResult result{checker.result(), board.status(), time.count(), pace.first_clock(),
                       std::nullopt};
    if (result.status.clocks > 0 && !board.paced() && !run.job.options.stall_seed) {
        result.period_clocks = pace.period();
    }
    return result;
}

}  // namespace curvecore::sysc
