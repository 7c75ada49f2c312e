// SPDX-License-Identifier: Apache-2.0
// Search through every state that a circuit can reach, until no new one comes: a proof over any
// number of clocks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tb/formal/search/lanes.hpp"
#include "tb/formal/search/registers.hpp"
#include "tb/formal/search/state_set.hpp"

namespace curvecore::formal {

/// May or must. A proof asks whether a bad literal may be 1, in every clock in which the
/// constraints may hold; latches without a start value are unknown at first. A search for a path
/// asks whether it must be 1 where the constraints must hold; latches without a start value are 0.
enum class Question { kMay, kMust };

class Search {
  public:
    Search(const Circuit& circuit, std::vector<Forget> rules, Question question);

    /// Searches until all states are known, or `enough` bad literals were reached. Throws
    /// std::runtime_error if there are too many states.
    void run(std::size_t enough);

    const StateSet& states() const { return states_; }
    std::size_t clocks() const { return clocks_; }  ///< number to the farthest state from the start
    std::size_t reached() const { return reached_; }
    /// Returns the state in which each bad literal was first 1.
    const std::vector<std::optional<std::uint32_t>>& where() const { return where_; }

  private:
    void insert_start();
    Lanes legal() const;
    void note_bad(std::uint32_t state, Lanes legal);
    void insert_next(std::uint32_t state, Lanes legal);

    const Circuit& circuit_;
    std::vector<Forget> rules_;
    Question question_;
    Simulation simulation_;
    StateSet states_;
    std::size_t clocks_ = 0;
    std::size_t reached_ = 0;
    std::vector<std::optional<std::uint32_t>> where_;  // by bad literal
    std::vector<Lanes> rails_;                         // rails of the next states
    std::vector<std::array<std::uint64_t, kLanes>> next_;
};

}  // namespace curvecore::formal
