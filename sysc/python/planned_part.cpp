// SPDX-License-Identifier: Apache-2.0
#include "sysc/python/planned_part.hpp"

#include "sysc/board/feeder.hpp"
#include "sysc/board/kernel_board.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {
PlannedPart::PlannedPart(const std::vector<std::string>& arguments)
    : job_(plan_job(read_part_options(arguments))) {}

std::vector<std::uint64_t> PlannedPart::segment_words() const {
    SegmentWriter writer(job_.options.core, job_.digest());
    std::vector<std::uint64_t> all;
    for (std::size_t n = 0; n < job_.plan.segments.size(); ++n) {
        const std::vector<std::uint64_t> words = writer.write(job_.plan.segments[n]);
        all.insert(all.end(), words.begin(), words.end());
    }
    return all;
}

std::vector<std::uint64_t> PlannedPart::profile_words() const {
    std::vector<std::uint64_t> all;
    for (std::size_t n = 0; n < job_.plan.pieces.size(); ++n) {
        const auto [words, count] = job_.plan.words_of(n);
        all.insert(all.end(), words, words + count);
    }
    return all;
}

PlannedPart::Samples PlannedPart::draw() const {
    KernelBoard board(job_.options.core, board_settings(job_));
    const std::uint64_t count = count_samples(job_.plan, job_.options.samples_per_tick_log2(),
                                              job_.options.override_word());
    Feeder feeder(job_, count, board);
    const auto axes = static_cast<std::size_t>(this->axes());
    Samples drawn;
    drawn.position.reserve((count + 1) * axes);
    drawn.fine.reserve((count + 1) * axes);
    const RunTimeFormat format(job_.options.core, this->axes());
    const RunSegment first = JoinedSegments(format).next(job_.plan.segments.front());
    for (std::size_t axis = 0; axis < axes; ++axis) {
        drawn.position.push_back(hls::to_position(first.start[axis], format));
        drawn.fine.push_back(first.start[axis]);
    }
    std::vector<Sample> batch;
    while (!feeder.done()) {
        batch.clear();
        feeder.turn(batch);
        for (const Sample& sample : batch) {
            for (std::size_t axis = 0; axis < axes; ++axis) {
                drawn.position.push_back(sample.position[axis]);
                drawn.fine.push_back(sample.fine[axis]);
            }
        }
    }
    return drawn;
}

}  // namespace curvecore::sysc
