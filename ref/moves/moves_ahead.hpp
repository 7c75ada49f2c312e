// SPDX-License-Identifier: Apache-2.0
// Moves that another thread reads ahead of the one that takes them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "ref/moves/events.hpp"
#include "ref/moves/move_source.hpp"
#include "ref/numeric/workers.hpp"

namespace curvecore::ref {

/// Its source is asked in one thread at a time, and never again once it has given its last move or
/// an error; both are given when they are due.
class MovesAhead {
  public:
    /// @param events of the source, as far as it has read
    /// @param most moves that wait
    MovesAhead(MoveSource source, std::function<const Events&()> events,
               std::shared_ptr<Workers> workers, std::size_t most);
    MovesAhead(const MovesAhead&) = delete;
    MovesAhead& operator=(const MovesAhead&) = delete;
    /// Waits until no thread reads.
    ~MovesAhead();

    /// Gives the next move; returns false if there is none. @throws what the source throws
    bool next(Move& move);

    /// The events that had been read once the last given move was read.
    const Events& events() const { return events_; }

  private:
    struct Read {
        Move move;
        std::vector<std::pair<std::string, Events::Event>> events;  // read with it
        bool ends;
        std::exception_ptr error;
    };

    void read_ahead();
    Read read();
    void read_one(std::unique_lock<std::mutex>& lock);

    const MoveSource source_;
    const std::function<const Events&()> read_events_;
    const std::size_t most_;
    std::size_t events_read_ = 0;
    Events events_;  // of the moves that were given
    bool ended_ = false;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Read> waiting_;
    bool asked_ = false;    // a worker will read
    bool reading_ = false;  // a thread reads
    bool all_read_ = false;
    bool stop_ = false;
    const std::shared_ptr<Workers> workers_;
};

}  // namespace curvecore::ref
