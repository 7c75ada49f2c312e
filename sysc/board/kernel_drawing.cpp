// SPDX-License-Identifier: Apache-2.0
#include "sysc/board/kernel_drawing.hpp"

#include "sysc/board/feeder.hpp"
#include "sysc/board/kernel_board.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {

Sample start_of(const Job& job) {
    const int axes = job.options.core.axes();
    const RunTimeFormat format(job.options.core, axes);
    const RunSegment first = JoinedSegments(format).next(job.plan.segments.front());
    Sample start;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
        start.position[axis] = hls::to_position(first.start[axis], format);
        start.fine[axis] = first.start[axis];
    }
    return start;
}

std::uint64_t count_samples(const Job& job) {
    return count_samples(job.plan, job.options.samples_per_tick_log2(),
                         job.options.override_word());
}

BoardStatus draw_by_kernel(const Job& job, std::uint64_t samples,
                           const std::function<void(const Sample& sample)>& take) {
    KernelBoard board(job.options.core, board_settings(job));
    Feeder feeder(job, samples, board);
    std::vector<Sample> batch;
    while (!feeder.done()) {
        batch.clear();
        feeder.turn(batch);
        for (const Sample& sample : batch) take(sample);
    }
    return board.status();
}

}  // namespace curvecore::sysc
