// SPDX-License-Identifier: Apache-2.0
// The stream of a program to a board, with a person's wishes on the way.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "sysc/panel/wish.hpp"
#include "sysc/wire/remote_machine.hpp"
#include "sysc/wire/rest_plan.hpp"

namespace curvecore::sysc {

/// End of a stream; kCaught: the switch that the board waited for has changed.
enum class StreamEnd { kDone, kStopped, kFault, kCaught };

/// Returns the rate of time, at most `rate`, at which a link of so many words a second (0: any
/// number) carries a program with so many in its busiest second. It is its own rate: a rate that
/// was set is not set again.
inline double rate_that_link_carries(double words_per_s, double busiest, double rate) {
    return words_per_s > 0 && busiest > 0 ? std::min(rate, words_per_s / busiest) : rate;
}

class WireStream {
  public:
    /// @param rest plans what is behind a hold anew; null: time runs again by the bounds of holds
    WireStream(RemoteMachine& machine, WordSource& words, WishQueue& wishes, double override_rate,
               RestPlan* rest = nullptr);

    /// Sends words and works until the program is drawn or ended. `turn` is called repeatedly.
    /// @throws BoardLost, Interrupted (by `turn`), any error of planning
    StreamEnd run(const std::function<void()>& turn);

    /// Stops on the path and empties the queues: after run() ended by an exception, or with
    /// kCaught.
    void stop();

    /// Returns the source of what is sent now.
    WordSource& words() const { return *words_; }
    /// Returns where what is sent now begins, quanta: at the last hold from which it was planned.
    std::uint64_t begin() const { return begin_; }
    const PlannedWords& planned() const { return planned_; }
    /// Returns the path that the board has drawn, quanta.
    std::uint64_t path() const { return path_; }
    /// Returns the faults, bits of STATE.
    std::uint32_t faults() const { return faults_; }
    bool held() const { return held_; }
    /// Returns where the board waited for words, quanta: each time that time stopped, or slowed
    /// first.
    const std::vector<std::uint64_t>& waits() const { return waits_; }
    /// Returns the rate of time that the link's words a second allow, at most 1.
    double link_rate() const { return link_rate_; }
    int override_percent() const { return static_cast<int>(std::lround(100 * wished_rate_)); }
    /// Returns true while the board waits for words.
    bool waiting() const { return waiting_; }
    /// Returns the wait for a person where the machine stands now; null: none.
    const ref::PlannedWait* wait() const {
        return waits_for_person_ ? &planned_.waits.front().wait : nullptr;
    }

  private:
    bool meet_wishes();
    void plan_rest();
    void resume();
    void begin_rest();
    void forget_rest();
    void empty_queues(bool keep_outputs);
    void look_until(const std::function<bool()>& done);
    void push();
    bool drawn() const;
    bool at_wait() const;
    void settle();
    void look();
    void see_waits();
    void keep_to_link();
    void set_rate(double wished);

    RemoteMachine& machine_;
    WordSource* words_;
    std::unique_ptr<WordSource> anew_;  // which words_ are, behind a hold
    std::unique_ptr<WordSource> next_;  // the rest of what is held
    RestPlan* rest_;
    WishQueue& wishes_;
    PlannedWords planned_;
    double wished_rate_;
    double link_rate_ = 1;
    double raised_ = 1;  // WordSource::raised()
    std::uint64_t begin_ = 0;
    std::uint64_t path_ = 0;
    RemoteMachine::WordCounts pushed_;
    std::uint32_t faults_ = 0;
    std::vector<std::uint64_t> waits_;
    bool waiting_ = false;
    bool waits_for_person_ = false;
    bool holds_ = false;                      // somebody asked for it
    std::optional<std::uint64_t> rest_at_;    // place of the rest that is asked for
    std::optional<std::uint64_t> waited_at_;  // place of the last wait for a person
    /// Longest wait for words: a fast board's clock advances with each question, so a host without
    /// words asks seldom while its planning thread is late.
    WireClock::duration awaits_ = std::chrono::milliseconds(50);
    std::optional<WireClock::time_point> resumes_by_;  // somebody asked to go on
    bool held_ = false;  // true: time stopped or slowed, for any reason
};

}  // namespace curvecore::sysc
