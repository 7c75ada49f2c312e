// SPDX-License-Identifier: Apache-2.0
// The microcode of time and path with queues of pieces and branches, beside the kernels, as
// sysc/board/kernel_board.cpp composes them.
#pragma once

#include <algorithm>
#include <deque>

#include "hls/path_kernel.hpp"
#include "hls/stop_schedule.hpp"
#include "tb/model/engine/time_microcode.hpp"
#include "tb/support/segments/random_pieces.hpp"

namespace curvecore::tb {

/// Rate, branches, path and queue.
class PathTimeComparison : public TimeComparison {
  public:
    using TimeComparison::TimeComparison;

    /// Runs a program of random pieces and branches to its end; targets change in its first ticks.
    void program(std::uint32_t seed, int pieces, int most_ticks, int ticks) {
        std::mt19937_64 random(seed);
        set_bounds(any_bounds(random, 1 << 22));
        path_ = hls::PathKernel();  // nothing is under way
        write(random, random_pieces(seed, pieces, most_ticks));
        const auto every = static_cast<unsigned>(random() % 3 == 0   ? 200
                                                 : random() % 2 == 0 ? 20
                                                                     : 6);
        const std::int32_t running = any_running(random);
        std::int32_t target = running;
        std::size_t entered = 0;
        for (int n = 0;
             n < ticks + 20 || entered < words_of_.size() || pieces_ > 0 || path_.active(); ++n) {
            if (random() % every == 0) {
                target = random() % 3 == 0 ? any_target(random) : target == 0 ? running : 0;
            }
            if (n >= ticks) target = 65536;
            std::uint64_t more = random() % 3 == 0 ? random() % 40 : 0;
            for (; more > 0 && entered < words_of_.size() && room(); --more) {
                enter(words_of_[entered++]);
            }
            tick(target);
            if (differ_ > 0) return;
            if (n > 20000) throw std::runtime_error("no end");
        }
    }

  private:
    struct Queued {
        std::uint64_t word;
        std::int32_t whole;  // ticks of the piece that it completes, or 0
        bool final;
    };

    void write(std::mt19937_64& random, const std::vector<hls::ProfileWords>& pieces) {
        words_of_.clear();
        for (const hls::ProfileWords& piece : pieces) {
            if (random() % (&piece == pieces.data() ? 2 : 3) != 0) {
                const auto wait = static_cast<std::int32_t>(
                    random() % 20 == 0 ? 1 + random() % ((1 << 20) - 1) : 1 + random() % 120);
                const bool again = known_ && random() % 3 == 0;
                words_of_.push_back({hls::pack_stop(wait, again), 0, false});
                std::uint64_t steps = random() % 40 == 0 || &piece == pieces.data()
                                          ? 256 + random() % 8
                                          : 1 + random() % 9;
                if (again) steps = 0;
                known_ = true;
                for (std::uint64_t n = 1; n <= steps; ++n) {
                    words_of_.push_back({hls::pack(any_step(random, n == steps)), 0, false});
                }
            }
            std::uint64_t words[hls::kProfileBusWords];
            hls::pack(piece, static_cast<unsigned>(random() % 256), words);
            for (int n = 0; n < hls::kProfileBusWords; ++n) {
                if (n > 1) words[n] |= hls::put(hls::kCheckField, random() % 256);
                words_of_.push_back(
                    {words[n], n == hls::kProfileBusWords - 1 ? piece.ticks : 0, piece.final});
            }
        }
    }

    bool room() { return machine_.get("profile_words") < kQueueWords; }

    void enter(const Queued& queued) {
        if (put_ >= kProfileEnd && may_wrap(queued.word)) put_ = kProfileBegin;
        write_word(machine_.ports().memory, put_, queued.word);
        put_ += 3;
        machine_.set("profile_words", machine_.get("profile_words") + 1);
        queue_.push_back(queued.word);
        if (queued.whole == 0) return;
        machine_.set("pieces", machine_.get("pieces") + 1);
        machine_.set("queued_ticks", machine_.get("queued_ticks") + queued.whole);
        machine_.set("finals", machine_.get("finals") + (queued.final ? 1 : 0));
        ticks_ += queued.whole;
        finals_ += queued.final ? 1 : 0;
        ++pieces_;
    }

    void tick(std::int32_t target) {
        std::size_t calls = 0;
        for (; machine_.get("next") == 0 && machine_.get("pieces") > 0; ++calls) {
            run(kFetch);
            if (calls > kQueueWords) throw std::runtime_error("no end");
        }
        same(calls <= 4 + fetched() / 2, 1);
        run(kFetch);  // to no effect
        machine_.set("target", target);
        const hls::StopDue due = stops_.due();
        same(machine_.get("near") == 0, due.wait > 0);
        if (due.wait > 0) {
            expect("next_wait", due.wait);
            expect("begins", due.begins ? 1 : 0);
        }
        run(kRate);
        run(kTick);
        const bool active = path_.active();
        const std::int32_t rate =
            scaler_.tick(target, path_.idle(), due, [this] { return stops_.next_step(); });
        stops_.count(scaler_.steady(), scaler_.passed());
        const auto next = [&](hls::ProfileWords& words) {
            if (pieces_ == 0) return false;
            words = next_piece();
            stops_.begin_piece(!path_.active());
            ticks_ -= words.ticks;
            finals_ -= words.final ? 1 : 0;
            --pieces_;
            return true;
        };
        const std::int64_t increment = path_.tick(rate, next, target == 0);
        expect("rate", rate);
        expect("increment", increment);
        expect("active", path_.active() ? 1 : 0);
        same(path_.idle(), machine_.get("idle") == hls::kIdleTicks);
        standing(target, rate, active);
        expect("queued_ticks", ticks_);
        expect("finals", finals_);
        expect("profile_words", static_cast<std::int64_t>(queue_.size() - fetched()));
        same(pieces_, machine_.get("pieces") + machine_.get("next"));
    }

    /// Words of the queue that the engine has fetched already: those of the next piece.
    std::size_t fetched() {
        if (machine_.get("next") == 0) return 0;
        const auto piece = std::find_if(queue_.begin(), queue_.end(), [](std::uint64_t word) {
            return hls::get(hls::kTagField, word) == static_cast<int>(hls::Tag::kPiece);
        });
        return static_cast<std::size_t>(piece - queue_.begin()) + hls::kProfileBusWords;
    }

    std::uint64_t pop() {
        const std::uint64_t word = queue_.front();
        queue_.pop_front();
        return word;
    }

    hls::ProfileWords next_piece() {
        for (;;) {
            const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, queue_.front()));
            if (tag == hls::Tag::kStop) {
                const std::uint64_t word = pop();
                stops_.load_wait(static_cast<std::int32_t>(hls::get(hls::kStopWaitField, word)),
                                 hls::get(hls::kStopAgainField, word) != 0);
            } else if (tag == hls::Tag::kStep) {
                stops_.load_step(hls::unpack_step(pop()));
            } else {
                return hls::unpack_piece([this] { return pop(); });
            }
        }
    }

    hls::StopSchedule stops_;
    hls::PathKernel path_;
    std::deque<std::uint64_t> queue_;
    std::vector<Queued> words_of_;
    std::int64_t ticks_ = 0;  // of the queued pieces
    std::int64_t finals_ = 0;
    std::int64_t pieces_ = 0;
    bool known_ = false;  // a branch came whose steps another may have
    int put_ = kProfileBegin;
};

}  // namespace curvecore::tb
