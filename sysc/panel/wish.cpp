// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/wish.hpp"

#include <algorithm>
#include <sstream>

#include "sysc/job/options.hpp"

namespace curvecore::sysc {

std::optional<Wish> wish_of(const std::string& text) {
    using Kind = Wish::Kind;
    std::istringstream words(text);
    std::string word;
    std::string more;
    words >> word;
    int percent = 0;
    const bool rate =
        word == "override" && words >> percent && percent >= 1 && percent <= kMostOverride;
    if (words >> more) return std::nullopt;
    if (rate) return Wish{Kind::kOverride, percent};
    if (word == "hold") return Wish{Kind::kHold};
    if (word == "resume") return Wish{Kind::kResume};
    if (word == "stop") return Wish{Kind::kStop};
    if (word == "estop") return Wish{Kind::kEstop};
    return std::nullopt;
}

void WishQueue::push(const Wish& wish) {
    const std::lock_guard lock(mutex_);
    const auto same = [&wish](const Wish& other) { return other.kind == wish.kind; };
    wishes_.erase(std::remove_if(wishes_.begin(), wishes_.end(), same), wishes_.end());
    if (wish.kind == Wish::Kind::kEstop) {
        wishes_.push_front(wish);
    } else {
        wishes_.push_back(wish);
    }
}

std::optional<Wish> WishQueue::next() {
    const std::lock_guard lock(mutex_);
    if (wishes_.empty()) return std::nullopt;
    const Wish wish = wishes_.front();
    wishes_.pop_front();
    return wish;
}

}  // namespace curvecore::sysc
