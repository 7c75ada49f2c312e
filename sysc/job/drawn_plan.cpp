// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/drawn_plan.hpp"

#include <algorithm>

#include "ref/feed/stops/stop_branch.hpp"

namespace curvecore::sysc {

void DrawnPlan::append(const ref::Plan& part) {
    static_cast<ref::PlanFrame&>(*this) = part;
    for (const ref::Segment& segment : part.segments) append(segment);
    for (std::size_t i = 0; i < part.pieces.size(); ++i) {
        first_word_.push_back(profile_words_.size());
        for (const std::uint64_t word : writer_.write(part, i)) {
            profile_words_.push_back(word);
        }
        pieces.push_back(part.pieces[i]);
    }
    for (const ref::PlannedOutput& output : part.outputs) outputs.push_back(output);
    for (const ref::PlannedBranch& branch : part.branches) {
        longest_stop = std::max(longest_stop, wait_ + ref::ticks_of(branch.steps));
        wait_ = branch.wait;
    }
    if (!part.branches.empty()) longest_stop = std::max(longest_stop, wait_);
    branches += part.branches.size();
    duration_s += part.duration_s;
}

void DrawnPlan::append(const ref::Segment& segment) {
    OfKind& kind = kinds_[segment.kind()];
    ++kind.count;
    kind.bound = std::max(kind.bound, segment.bound);
    stops += stop_behind_ || segments.empty();
    stop_behind_ = segment.length > 0 && ends_at_rest(segment);
    segments.push_back(segment);
}

std::size_t DrawnPlan::words(int segment_words) const {
    return static_cast<std::size_t>(segment_words) * segments.size() + profile_words_.size();
}

std::pair<const std::uint64_t*, std::size_t> DrawnPlan::words_of(std::size_t piece) const {
    const std::size_t first = first_word_[piece];
    const std::size_t end =
        piece + 1 < pieces.size() ? first_word_[piece + 1] : profile_words_.size();
    return {&profile_words_[first], end - first};
}

}  // namespace curvecore::sysc
