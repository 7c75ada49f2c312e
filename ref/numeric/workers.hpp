// SPDX-License-Identifier: Apache-2.0
// Threads beside the one that plans. What they are asked for gives the same in any order, so that
// their number changes no result.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace curvecore::ref {

class Workers {
  public:
    /// @param threads with the caller's own; fewer where the system has no more
    explicit Workers(int threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    /// Waits for the work that is under way; what has not begun is left out.
    ~Workers();

    /// Does work(0) .. work(count - 1), in any order: here, work(0) in any case, and in threads
    /// that have nothing else to do. @throws what one of them throws, the first by its number
    void each(std::size_t count, const std::function<void(std::size_t)>& work);

    /// Begins work in another thread, when one has nothing else to do.
    void begin(std::function<void()> work);

    int threads() const { return static_cast<int>(threads_.size()) + 1; }

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> waiting_;
    std::size_t idle_ = 0;  // threads that wait for work
    bool stop_ = false;
    std::vector<std::thread> threads_;  // last member: they use the others
};

/// Does work(0) .. work(count - 1) by these workers; none: one after the other.
void each(const std::shared_ptr<Workers>& workers, std::size_t count,
          const std::function<void(std::size_t)>& work);

}  // namespace curvecore::ref
