// SPDX-License-Identifier: Apache-2.0
// A program on its way to a board, and what an operator asks for on the way.
#pragma once

#include <functional>

#include "sysc/wire/console.hpp"
#include "sysc/wire/remote_machine.hpp"
#include "sysc/wire/word_source.hpp"

namespace curvecore::sysc {

/// kCaught: the switch that the board was to wait for was there.
enum class StreamEnd { kDone, kStopped, kFault, kCaught };

class WireStream {
  public:
    WireStream(RemoteMachine& machine, WordSource& words, Console& console, double override_rate);

    /// Sends words and works until the program has been drawn, or was ended. `turn` is called again
    /// and again.
    /// @throws BoardLost, Interrupted (by `turn`), what ended the planning
    StreamEnd run(const std::function<void()>& turn);

    /// Stops on the path, empties the queues: after run() was left by an exception, or caught.
    void stop();

    const PlannedWords& planned() const { return planned_; }
    /// Quanta that the board has drawn.
    std::uint64_t path() const { return path_; }
    /// Bits of STATE.
    std::uint32_t faults() const { return faults_; }
    bool held() const { return held_; }
    /// Where it waited for words, quanta: each time that time stood still, or was slowed first.
    const std::vector<std::uint64_t>& waits() const { return waits_; }
    /// Rate of time that the link's words a second allow, at most 1.
    double link_rate() const { return link_rate_; }

  private:
    bool meet_wishes();
    bool drawn() const;
    void look();
    void see_waits();
    void keep_to_link();
    void set_rate(double wished);

    RemoteMachine& machine_;
    WordSource& words_;
    Console& console_;
    PlannedWords planned_;
    double wished_rate_;
    double link_rate_ = 1;
    std::uint64_t path_ = 0;
    std::uint32_t faults_ = 0;
    std::vector<std::uint64_t> waits_;
    bool waiting_ = false;
    bool held_ = false;  // time stood still or went slower, for whatever reason
};

}  // namespace curvecore::sysc
