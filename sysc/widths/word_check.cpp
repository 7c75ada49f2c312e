// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/word_check.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "ref/program/input_error.hpp"
#include "sysc/widths/run_time_kernel.hpp"

namespace curvecore::sysc {

void check_words(const Job& job) {
    const CoreParameters& core = job.options.core;
    ValueRanges ranges(core.coef_bits);
    for (const ref::Segment& segment : job.plan.segments) {
        const auto refuse = [&](const std::string& reason) {
            throw ref::InputError(job.program.file, job.program.moves[segment.move].line, reason);
        };
        try {
            const RunSegment words = to_run_words(segment, core, core.axes());
            RunTimeKernel kernel(core, core.axes(), ranges);
            RunWord end[kMostAxes];
            kernel.sample(
                words.length, [&] { return words; }, end);
        } catch (const std::range_error& error) {
            refuse(error.what());
        }
        if (ranges.missing() > 0) {
            refuse(fmt::format("a word of the core's network would need {} more bits for this {}",
                               ranges.missing(), ref::kind_name(segment)));
        }
    }
}

}  // namespace curvecore::sysc
