// SPDX-License-Identifier: Apache-2.0
#include "sysc/python/planned_part.hpp"

#include "sysc/board/kernel_drawing.hpp"
#include "sysc/commands/options/part_options.hpp"

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
    const std::uint64_t count = count_samples(job_);
    const auto axes = static_cast<std::size_t>(this->axes());
    Samples drawn;
    drawn.position.reserve((count + 1) * axes);
    drawn.fine.reserve((count + 1) * axes);
    const auto take = [&](const Sample& sample) {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            drawn.position.push_back(sample.position[axis]);
            drawn.fine.push_back(sample.fine[axis]);
        }
    };
    take(start_of(job_));
    draw_by_kernel(job_, count, take);
    return drawn;
}

}  // namespace curvecore::sysc
