// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/queue_guard.hpp"

#include <algorithm>

#include "ref/format/path_words.hpp"

namespace curvecore::sysc {

QueueGuard::QueueGuard(const Job& job)
    : job_(job),
      stop_ticks_(job.plan.stop_ticks),
      rate_log2_(16 + job.options.samples_per_tick_log2()) {
    const std::array<std::size_t, 2> counts{job.plan.segments.size(), job.plan.pieces.size()};
    for (const Stream stream : {Stream::kSegments, Stream::kProfile}) {
        Cover& cover = covers_[static_cast<std::size_t>(stream)];
        cover.count = counts[static_cast<std::size_t>(stream)];
        if (!cover.complete()) cover.next = item(stream, 0).first;
    }
}

std::pair<std::uint64_t, std::int64_t> QueueGuard::item(Stream stream, std::size_t index) const {
    const DrawnPlan& plan = job_.plan;
    if (stream == Stream::kProfile) return {plan.words_of(index).second, plan.pieces[index].ticks};
    const int words = job_.options.core.segment_words();
    return {static_cast<std::uint64_t>(words), plan.segments[index].ticks};
}

void QueueGuard::enters(Stream stream) {
    Cover& cover = covers_[static_cast<std::size_t>(stream)];
    ++cover.entered;
    if (cover.complete() || cover.entered < cover.next) return;
    cover.ticks += item(stream, cover.whole++).second;
    if (!cover.complete()) cover.next += item(stream, cover.whole).first;
}

void QueueGuard::made(std::int32_t rate) {
    rates_ += rate;
    const std::int64_t taken = rates_ >> rate_log2_;
    const bool low = std::any_of(covers_.begin(), covers_.end(), [&](const Cover& cover) {
        return !cover.complete() && cover.ticks - taken <= stop_ticks_ + kAge;
    });
    if (low && !low_) ++times_;
    low_ = low;
}

}  // namespace curvecore::sysc
