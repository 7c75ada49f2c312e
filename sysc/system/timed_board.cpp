// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/timed_board.hpp"

#include <cstring>

namespace curvecore::sysc {

TimedBoard::TimedBoard(const sc_core::sc_module_name& name) : sc_module(name) {
    SC_HAS_PROCESS(TimedBoard);
    bus.register_b_transport(this, &TimedBoard::transport);
    SC_THREAD(run_periods);
}

void TimedBoard::begin(const BoardParts& parts) {
    parts_ = parts;
    run_ = Run();
    sample_time_ = seconds(parts.sample_s);
}

void TimedBoard::end() { tick_.cancel(); }

void TimedBoard::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& /*time*/) {
    std::uint64_t word = 0;
    std::memcpy(&word, payload.get_data_ptr(), sizeof word);
    bool taken = true;
    switch (payload.get_address()) {
        case kSegmentWords:
            taken = take(Stream::kSegments, word);
            break;
        case kProfileWords:
            taken = take(Stream::kProfile, word);
            break;
        case kRequest:
            want(word);
            break;
        default:
            payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
            return;
    }
    payload.set_response_status(taken ? tlm::TLM_OK_RESPONSE : tlm::TLM_GENERIC_ERROR_RESPONSE);
}

bool TimedBoard::take(Stream stream, std::uint64_t word) {
    Board& core = *parts_.core;
    while (core.write(stream, &word, 1) == 0) {
        if (core.full(stream)) return false;
        work();
    }
    while (!core.arrived(stream) && !core.full(stream)) work();
    parts_.guard->enters(stream);
    return true;
}

void TimedBoard::want(std::uint64_t samples) {
    if (!under_way()) tick_.notify(sample_time_);
    run_.wanted += samples;
}

/// Does a turn of the core.
void TimedBoard::work() {
    parts_.core->work(came_);
    run_.asked -= came_.size();
    for (const Sample& sample : came_) {
        parts_.guard->made(sample.rate);
        run_.made.push_back(sample);
    }
    came_.clear();
}

bool TimedBoard::under_way() const {
    return run_.wanted > 0 || run_.asked > 0 || !run_.made.empty() || run_.rest > 0;
}

void TimedBoard::run_periods() {
    for (;;) {
        wait(tick_);
        const sc_core::sc_time next = sc_core::sc_time_stamp() + sample_time_;
        period();
        if (under_way()) tick_.notify(next - sc_core::sc_time_stamp());
    }
}

void TimedBoard::period() {
    if (run_.rest > 0) {
        move(&run_.last);
        --run_.rest;
    } else {
        take_sample();
    }
}

void TimedBoard::move(const Sample* sample) {
    if (parts_.machine == nullptr) return;
    const std::vector<PinChange>& changes = parts_.machine->period(sample);
    if (parts_.trace != nullptr) parts_.trace->play(*parts_.machine, changes);
}

/// Lets the core work for at most the time of a sample, and takes one.
void TimedBoard::take_sample() {
    while (run_.wanted > 0 && run_.asked + run_.made.size() < parts_.ahead) {
        parts_.core->request(1);
        --run_.wanted;
        ++run_.asked;
    }
    for (std::uint64_t turn = 0; run_.asked > 0 && turn < parts_.turns_per_sample; ++turn) work();
    const bool late = run_.made.empty();
    if (late) {
        ++run_.late_samples;
    } else {
        run_.last = run_.made.front();
        run_.made.pop_front();
        run_.samples.push_back(run_.last);
    }
    const bool last = !late && !under_way();
    if (last) run_.rest = kRest;
    move(late ? nullptr : &run_.last);
}

}  // namespace curvecore::sysc
