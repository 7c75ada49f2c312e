// SPDX-License-Identifier: Apache-2.0
#include "ref/numeric/workers.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <utility>

namespace curvecore::ref {
namespace {

/// Numbered pieces of work that several threads take one by one.
class SharedWork {
  public:
    SharedWork(std::size_t count, const std::function<void(std::size_t)>& work)
        : work_(work), count_(count), errors_(count) {}

    /// Does a piece, and others until none is left. Threads that come when all are taken touch no
    /// work.
    void take(std::size_t first) {
        for (std::size_t i = first; i < count_; i = next_++) {
            try {
                work_(i);
            } catch (...) {
                errors_[i] = std::current_exception();
            }
            const std::lock_guard lock(mutex_);
            if (++done_ == count_) all_done_.notify_all();
        }
    }
    std::size_t next() { return next_++; }
    void wait() {
        std::unique_lock lock(mutex_);
        all_done_.wait(lock, [this] { return done_ == count_; });
        for (const std::exception_ptr& error : errors_) {
            if (error) std::rethrow_exception(error);
        }
    }

  private:
    const std::function<void(std::size_t)>& work_;  // outlives its last piece, not this
    const std::size_t count_;
    std::vector<std::exception_ptr> errors_;
    std::atomic<std::size_t> next_{1};
    std::mutex mutex_;
    std::condition_variable all_done_;
    std::size_t done_ = 0;
};

}  // namespace

Workers::Workers(int threads) {
    try {
        while (static_cast<int>(threads_.size()) < threads - 1) {
            threads_.emplace_back([this] { run(); });
        }
    } catch (const std::system_error&) {  // no more are to be had: what they make is the same
    }
}

Workers::~Workers() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void Workers::run() {
    for (;;) {
        std::unique_lock lock(mutex_);
        ++idle_;
        changed_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
        --idle_;
        if (stop_) return;
        const std::function<void()> work = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        work();
    }
}

void Workers::each(std::size_t count, const std::function<void(std::size_t)>& work) {
    const auto shared = std::make_shared<SharedWork>(count, work);
    {
        const std::lock_guard lock(mutex_);
        const std::size_t helpers = std::min(idle_, count - std::min<std::size_t>(count, 1));
        for (std::size_t i = 0; i < helpers; ++i) {
            waiting_.emplace_front([shared] { shared->take(shared->next()); });
        }
    }
    changed_.notify_all();
    shared->take(0);
    shared->wait();
}

void Workers::begin(std::function<void()> work) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(work));
    }
    changed_.notify_one();
}

void each(const std::shared_ptr<Workers>& workers, std::size_t count,
          const std::function<void(std::size_t)>& work) {
    if (workers) {
        workers->each(count, work);
    } else {
        for (std::size_t i = 0; i < count; ++i) work(i);
    }
}

}  // namespace curvecore::ref
