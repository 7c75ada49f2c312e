// SPDX-License-Identifier: Apache-2.0
// A bounded queue between two threads.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace curvecore::sysc {

template <class T>
class Channel {
  public:
    explicit Channel(std::size_t depth) : depth_(depth) {}

    /// Waits for room. Returns false if the channel is closed; the value is then discarded.
    bool push(T value) {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return queue_.size() < depth_ || closed_; });
        if (closed_) return false;
        queue_.push_back(std::move(value));
        changed_.notify_all();
        return true;
    }

    /// Waits for a value. Returns none once the channel is closed and empty.
    std::optional<T> pop() {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return !queue_.empty() || closed_; });
        if (queue_.empty()) return std::nullopt;
        std::optional<T> value(std::move(queue_.front()));
        queue_.pop_front();
        changed_.notify_all();
        return value;
    }

    void close() {
        const std::lock_guard<std::mutex> lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<T> queue_;
    std::size_t depth_;
    bool closed_ = false;
};

}  // namespace curvecore::sysc
