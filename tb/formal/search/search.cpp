// SPDX-License-Identifier: Apache-2.0
#include "tb/formal/search/search.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace curvecore::formal {

namespace {

constexpr std::size_t kMostStates = 30'000'000;  // of some 50 bytes
constexpr std::size_t kMostInputs = 16;

}  // namespace

Search::Search(const Circuit& circuit, std::vector<Forget> rules, Question question)
    : circuit_(circuit),
      rules_(std::move(rules)),
      question_(question),
      simulation_(circuit),
      states_(simulation_.words()),
      where_(circuit.bad.size()),
      rails_(kLanes * simulation_.words()),
      next_(simulation_.words()) {
    if (circuit.inputs > kMostInputs) throw std::runtime_error("too many inputs to try them all");
    insert_start();
}

void Search::insert_start() {
    State start(simulation_.words());
    for (std::size_t n = 0; n < circuit_.latches.size(); ++n) {
        std::uint64_t rails = circuit_.latches[n].start == Start::kOne ? 1 : 2;
        if (circuit_.latches[n].start == Start::kAny && question_ == Question::kMay) rails = 3;
        start[n / 32] |= rails << (2 * (n % 32));
    }
    states_.insert(start.data(), 0);
}

void Search::run(std::size_t enough) {
    const std::uint64_t blocks =
        circuit_.inputs > 6 ? std::uint64_t{1} << (circuit_.inputs - 6) : 1;
    std::size_t clock_ends = states_.size();
    for (std::size_t n = 0; n < states_.size() && reached_ < enough; ++n) {
        if (n == clock_ends) {
            ++clocks_;
            clock_ends = states_.size();
        }
        if (states_.size() > kMostStates) throw std::runtime_error("too many states");
        const auto state = static_cast<std::uint32_t>(n);
        simulation_.load(states_[n]);
        for (std::uint64_t block = 0; block < blocks; ++block) {
            simulation_.set_inputs(block);
            simulation_.evaluate();
            const Lanes lanes = legal();
            note_bad(state, lanes);
            insert_next(state, lanes);
        }
    }
}

Lanes Search::legal() const {
    Lanes lanes = ~Lanes{0};
    for (const Literal literal : circuit_.constraints) {
        lanes &= question_ == Question::kMay ? simulation_.may(literal) : simulation_.must(literal);
    }
    return lanes;
}

void Search::note_bad(std::uint32_t state, Lanes legal) {
    for (std::size_t n = 0; n < circuit_.bad.size(); ++n) {
        const Literal literal = circuit_.bad[n];
        const Lanes bad =
            question_ == Question::kMay ? simulation_.may(literal) : simulation_.must(literal);
        if (where_[n] || (bad & legal) == 0) continue;
        where_[n] = state;
        ++reached_;
    }
}

void Search::insert_next(std::uint32_t state, Lanes legal) {
    if (legal == 0) return;
    for (std::size_t n = 0; n < circuit_.latches.size(); ++n) {
        rails_[2 * n] = simulation_.may(circuit_.latches[n].next);
        rails_[2 * n + 1] = simulation_.may(circuit_.latches[n].next ^ 1u);
    }
    for (const Forget& rule : rules_) {
        const Lanes idle = ~rails_[2 * rule.guard];
        for (const std::size_t latch : rule.latches) {
            rails_[2 * latch] |= idle;
            rails_[2 * latch + 1] |= idle;
        }
    }
    for (std::size_t word = 0; word < next_.size(); ++word) {
        std::copy_n(&rails_[kLanes * word], kLanes, next_[word].begin());
        transpose(next_[word]);
    }
    State next(next_.size());
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        if ((legal >> lane & 1u) == 0) continue;
        for (std::size_t word = 0; word < next.size(); ++word) next[word] = next_[word][lane];
        states_.insert(next.data(), state);
    }
}

}  // namespace curvecore::formal
