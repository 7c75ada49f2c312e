// SPDX-License-Identifier: Apache-2.0
// A set of states in the order in which they were found, each with its predecessor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace curvecore::formal {

class StateSet {
  public:
    explicit StateSet(std::size_t words) : words_(words), table_(1 << 16, kNone) {}

    std::size_t size() const { return parents_.size(); }
    const std::uint64_t* operator[](std::size_t index) const { return &states_[index * words_]; }
    std::uint32_t parent(std::size_t index) const { return parents_[index]; }

    void insert(const std::uint64_t* state, std::uint32_t parent) {
        std::size_t place = hash(state) & (table_.size() - 1);
        while (table_[place] != kNone) {
            if (std::equal(state, state + words_, (*this)[table_[place]])) return;
            place = (place + 1) & (table_.size() - 1);
        }
        table_[place] = static_cast<std::uint32_t>(size());
        states_.insert(states_.end(), state, state + words_);
        parents_.push_back(parent);
        if (2 * size() > table_.size()) grow();
    }

  private:
    static constexpr std::uint32_t kNone = 0xffffffff;

    std::size_t hash(const std::uint64_t* state) const {
        std::uint64_t sum = 0;
        for (std::size_t n = 0; n < words_; ++n) {
            sum = (sum ^ state[n]) * 0x9e3779b97f4a7c15;
            sum ^= sum >> 29;
        }
        return sum;
    }
    void grow() {
        table_.assign(2 * table_.size(), kNone);
        for (std::size_t index = 0; index < size(); ++index) {
            std::size_t place = hash((*this)[index]) & (table_.size() - 1);
            while (table_[place] != kNone) place = (place + 1) & (table_.size() - 1);
            table_[place] = static_cast<std::uint32_t>(index);
        }
    }

    std::size_t words_;
    std::vector<std::uint64_t> states_;
    std::vector<std::uint32_t> parents_;
    std::vector<std::uint32_t> table_;  // open addressing, at most half full
};

}  // namespace curvecore::formal
