// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/moves_ahead.hpp"

namespace curvecore::ref {

MovesAhead::MovesAhead(MoveSource source, std::function<const Events&()> events,
                       std::shared_ptr<Workers> workers, std::size_t most)
    : source_(std::move(source)),
      read_events_(std::move(events)),
      most_(most),
      workers_(std::move(workers)) {}

MovesAhead::~MovesAhead() {
    std::unique_lock lock(mutex_);
    stop_ = true;
    changed_.wait(lock, [this] { return !asked_ && !reading_; });
}

MovesAhead::Read MovesAhead::read() {
    Read read{};
    try {
        read.ends = !source_(read.move);
    } catch (...) {
        read.ends = true;
        read.error = std::current_exception();
    }
    try {
        const Events& events = read_events_();
        for (; events_read_ < events.list().size(); ++events_read_) {
            const Events::Event& event = events.list()[events_read_];
            read.events.emplace_back(events.code_of(event), event);
        }
    } catch (...) {
        read.ends = true;
        if (!read.error) read.error = std::current_exception();
    }
    return read;
}

/// Reads without the lock; the only thread that does.
void MovesAhead::read_one(std::unique_lock<std::mutex>& lock) {
    reading_ = true;
    lock.unlock();
    Read one = read();
    lock.lock();
    reading_ = false;
    all_read_ = one.ends;
    waiting_.push_back(std::move(one));
    changed_.notify_all();
}

void MovesAhead::read_ahead() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !reading_; });
    asked_ = false;  // from here on the lock is held wherever nobody reads
    while (!stop_ && !all_read_ && waiting_.size() < most_) read_one(lock);
    changed_.notify_all();
}

bool MovesAhead::next(Move& move) {
    if (ended_) return false;
    std::unique_lock lock(mutex_);
    const bool few = 2 * waiting_.size() <= most_ && workers_->threads() > 1;
    if (few && !asked_ && !reading_ && !all_read_) {
        asked_ = true;
        workers_->begin([this] { read_ahead(); });
    }
    // What is asked for may wait for this thread, too.
    while (waiting_.empty()) {
        if (reading_) {
            changed_.wait(lock);
        } else {
            read_one(lock);
        }
    }
    const Read one = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    for (const auto& [code, event] : one.events) events_.add(code, event);
    ended_ = one.ends;
    if (one.error) std::rethrow_exception(one.error);
    move = one.move;
    return !one.ends;
}

}  // namespace curvecore::ref
