// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/queue_guard.hpp"

#include <algorithm>

#include "ref/format/path_words.hpp"

namespace curvecore::sysc {

void QueueGuard::Cover::add(std::uint64_t more_words, std::int64_t more_ticks) {
    words.push_back(more_words + (words.empty() ? 0 : words.back()));
    ticks.push_back(more_ticks + (ticks.empty() ? 0 : ticks.back()));
}

QueueGuard::QueueGuard(const Job& job)
    : stop_ticks_(job.plan.stop_ticks), rate_log2_(16 + job.options.samples_per_tick_log2()) {
    const DrawnPlan& plan = job.plan;
    const int segment_words = ref::segment_bus_words(job.options.core.aux_axes);
    for (const ref::Segment& segment : plan.segments) {
        covers_[static_cast<std::size_t>(Stream::kSegments)].add(
            static_cast<std::uint64_t>(segment_words), segment.ticks);
    }
    for (std::size_t n = 0; n < plan.pieces.size(); ++n) {
        covers_[static_cast<std::size_t>(Stream::kProfile)].add(plan.words_of(n).second,
                                                                plan.pieces[n].ticks);
    }
}

void QueueGuard::enters(Stream stream) {
    Cover& cover = covers_[static_cast<std::size_t>(stream)];
    ++cover.entered;
    if (!cover.complete() && cover.entered == cover.words[cover.whole]) ++cover.whole;
}

void QueueGuard::made(std::int32_t rate) {
    rates_ += rate;
    const std::int64_t taken = rates_ >> rate_log2_;
    const bool low = std::any_of(covers_.begin(), covers_.end(), [&](const Cover& cover) {
        return !cover.complete() && cover.covered() - taken <= stop_ticks_ + kAge;
    });
    if (low && !low_) ++times_;
    low_ = low;
}

}  // namespace curvecore::sysc
