// SPDX-License-Identifier: Apache-2.0
// The stream of a program to a board, with a person's wishes on the way.
#pragma once

#include <cmath>
#include <functional>

#include "sysc/panel/wish.hpp"
#include "sysc/wire/remote_machine.hpp"
#include "sysc/wire/word_source.hpp"

namespace curvecore::sysc {

/// End of a stream; kCaught: the switch that the board waited for has changed.
enum class StreamEnd { kDone, kStopped, kFault, kCaught };

class WireStream {
  public:
    WireStream(RemoteMachine& machine, WordSource& words, WishQueue& wishes, double override_rate);

    /// Sends words and works until the program is drawn or ended. `turn` is called repeatedly.
    /// @throws BoardLost, Interrupted (by `turn`), any error of planning
    StreamEnd run(const std::function<void()>& turn);

    /// Stops on the path and empties the queues: after run() ended by an exception, or with
    /// kCaught.
    void stop();

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
    void push();
    bool drawn() const;
    bool at_wait() const;
    void settle();
    void look();
    void see_waits();
    void keep_to_link();
    void set_rate(double wished);

    RemoteMachine& machine_;
    WordSource& words_;
    WishQueue& wishes_;
    PlannedWords planned_;
    double wished_rate_;
    double link_rate_ = 1;
    double raised_ = 1;  // WordSource::raised()
    std::uint64_t path_ = 0;
    RemoteMachine::WordCounts pushed_;
    std::uint32_t faults_ = 0;
    std::vector<std::uint64_t> waits_;
    bool waiting_ = false;
    bool waits_for_person_ = false;
    bool held_ = false;  // true: time stopped or slowed, for any reason
};

}  // namespace curvecore::sysc
