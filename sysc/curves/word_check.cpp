// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/word_check.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "hls/quantise.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/kernel/run_time_kernel.hpp"

namespace curvecore::sysc {

void check_words(const Job& job, const ref::Plan& part) {
    const CoreParameters& core = job.options.core;
    ValueRanges ranges(core.coef_bits);
    const RunTimeFormat format(core, core.axes(), &ranges);
    for (const ref::Segment& segment : part.segments) {
        const auto refuse = [&](const std::string& reason) {
            throw ref::InputError(job.program.file, segment.line, reason);
        };
        try {
            const RunSegment words = hls::to_words(segment, format);
            RunTimeKernel kernel(format);
            std::int64_t end[kMostAxes];
            kernel.sample(
                words.length, [&] { return words; }, end);
        } catch (const std::range_error& error) {
            refuse(error.what());
        }
        if (ranges.missing() > 0) {
            refuse(fmt::format("a word of the core's network would need {} more bits for this {}",
                               ranges.missing(), segment.kind_name()));
        }
    }
}

}  // namespace curvecore::sysc
