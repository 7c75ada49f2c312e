// SPDX-License-Identifier: Apache-2.0
// The core's queues behind a register each, and a timer that takes a sample each period.
//
//     words -> core -> samples made ahead -> one a period -> machine
#pragma once

#include <deque>
#include <optional>

#include "sysc/board/board.hpp"
#include "sysc/system/bus.hpp"
#include "sysc/system/machine.hpp"
#include "sysc/system/pin_trace.hpp"
#include "sysc/system/queue_guard.hpp"

namespace curvecore::sysc {

/// Parts that a board draws with, from begin() to end().
struct BoardParts {
    Board* core = nullptr;
    Machine* machine = nullptr;  // null: samples move nothing
    QueueGuard* guard = nullptr;
    PinTrace* trace = nullptr;  // null: none
    double sample_s = 0;
    std::size_t ahead = 4;               // samples requested before they are due
    std::uint64_t turns_per_sample = 0;  // turns of the core's work
};

class TimedBoard : public sc_core::sc_module {
  public:
    tlm_utils::simple_target_socket<TimedBoard> bus{"bus"};

    explicit TimedBoard(const sc_core::sc_module_name& name);

    void begin(const BoardParts& parts);
    void end();

    /// Returns the samples that were taken since the last call.
    std::vector<Sample>& samples() { return run_.samples; }
    /// Returns true if all requested samples have come, and the pins still move.
    bool comes_to_rest() const { return run_.rest > 0; }
    std::uint64_t late_samples() const { return run_.late_samples; }

  private:
    /// Number of periods until the last step is out.
    static constexpr int kRest = 4;

    struct Run {
        std::uint64_t wanted = 0;  // samples, not requested from the core yet
        std::size_t asked = 0;     // requested, not made yet
        std::deque<Sample> made;
        std::vector<Sample> samples;  // samples taken
        Sample last;
        int rest = 0;
        std::uint64_t late_samples = 0;
    };

    void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& time);
    bool take(Stream stream, std::uint64_t word);
    void want(std::uint64_t samples);
    void work();
    bool under_way() const;
    void run_periods();
    void period();
    void take_sample();
    void move(const Sample* sample);

    BoardParts parts_;
    Run run_;
    sc_core::sc_time sample_time_;
    sc_core::sc_event tick_;
    std::vector<Sample> came_;  // samples of the core's last turn
};

}  // namespace curvecore::sysc
