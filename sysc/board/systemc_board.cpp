// SPDX-License-Identifier: Apache-2.0
//   host_port --b_transport--> bus --b_transport--> timed_board --> core
//
// Loosely timed: a word is in its queue when its transport returns, and the host waits for the time
// that the bus took. The core's clocks run while it has a word to take or a sample to give, and not
// between samples.
#include "sysc/board/systemc_board.hpp"

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstring>
#include <systemc>
#include <utility>

namespace curvecore::sysc {
namespace {

using sc_core::sc_time;
using tlm::tlm_generic_payload;

/// The board's addresses: words go to a stream's, the count of samples that are wanted to kRequest.
enum Address : std::uint64_t { kSegmentWords = 0, kProfileWords = 8, kRequest = 16 };

sc_time seconds(double time) { return sc_time(time, sc_core::SC_SEC); }

/// The host's end of the bus. The host is outside of the simulation, which runs while it waits.
class HostPort : public sc_core::sc_module {
  public:
    tlm_utils::simple_initiator_socket<HostPort> bus{"bus"};

    explicit HostPort(const sc_core::sc_module_name& name) : sc_module(name) {
        SC_HAS_PROCESS(HostPort);
        SC_THREAD(transact);
    }

    /// Writes word after word until one is refused, and returns how many were not.
    std::size_t write(std::uint64_t address, const std::uint64_t* words, std::size_t count) {
        address_ = address;
        words_ = words;
        count_ = count;
        asked_.notify(sc_core::SC_ZERO_TIME);
        sc_core::sc_start();
        return taken_;
    }

  private:
    void transact() {
        while (true) {
            wait(asked_);
            taken_ = 0;
            while (taken_ < count_ && send(words_[taken_])) ++taken_;
            sc_core::sc_pause();
        }
    }

    bool send(std::uint64_t word) {
        tlm_generic_payload payload;
        payload.set_write();
        payload.set_address(address_);
        payload.set_data_ptr(reinterpret_cast<unsigned char*>(&word));
        payload.set_data_length(sizeof word);
        payload.set_streaming_width(sizeof word);
        payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
        sc_time time = sc_core::SC_ZERO_TIME;
        bus->b_transport(payload, time);
        wait(time);
        return payload.is_response_ok();
    }

    sc_core::sc_event asked_;
    std::uint64_t address_ = 0;
    const std::uint64_t* words_ = nullptr;
    std::size_t count_ = 0;
    std::size_t taken_ = 0;
};

/// Each word takes its time.
class Bus : public sc_core::sc_module {
  public:
    tlm_utils::simple_target_socket<Bus> host{"host"};
    tlm_utils::simple_initiator_socket<Bus> board{"board"};

    Bus(const sc_core::sc_module_name& name, const sc_time& word_time)
        : sc_module(name), word_time_(word_time) {
        host.register_b_transport(this, &Bus::transport);
    }

  private:
    void transport(tlm_generic_payload& payload, sc_time& time) {
        time += word_time_;
        board->b_transport(payload, time);
    }

    const sc_time word_time_;
};

/// The core's queues behind a register each, and a timer that asks for the samples.
class TimedBoard : public sc_core::sc_module {
  public:
    tlm_utils::simple_target_socket<TimedBoard> bus{"bus"};

    TimedBoard(const sc_core::sc_module_name& name, Board& core, const SystemTimes& times)
        : sc_module(name),
          core_(core),
          sample_time_(seconds(times.sample_s)),
          turns_per_sample_(static_cast<std::uint64_t>(times.sample_s / times.clock_s)) {
        SC_HAS_PROCESS(TimedBoard);
        bus.register_b_transport(this, &TimedBoard::transport);
        SC_THREAD(serve);
    }

    /// Samples that came since they were taken last.
    std::vector<Sample>& samples() { return samples_; }
    std::uint64_t late_samples() const { return late_samples_; }

  private:
    void transport(tlm_generic_payload& payload, sc_time& /*time*/) {
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
                wanted_ += word;
                wanted_changed_.notify();
                break;
            default:
                payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
                return;
        }
        payload.set_response_status(taken ? tlm::TLM_OK_RESPONSE : tlm::TLM_GENERIC_ERROR_RESPONSE);
    }

    bool take(Stream stream, std::uint64_t word) {
        while (core_.write(stream, &word, 1) == 0) {
            if (core_.full(stream)) return false;
            work();
        }
        while (!core_.arrived(stream) && !core_.full(stream)) work();
        return true;
    }

    void work() {
        const std::size_t before = samples_.size();
        core_.work(samples_);
        pending_ -= samples_.size() - before;
    }

    void serve() {
        while (true) {
            while (wanted_ == 0) wait(wanted_changed_);
            wait(sample_time_);
            --wanted_;
            core_.request(1);
            ++pending_;
            draw();
        }
    }

    /// Lets the core work for as long as a sample may take.
    void draw() {
        for (std::uint64_t turn = 0; pending_ > 0 && turn < turns_per_sample_; ++turn) work();
        late_samples_ += pending_ > 0;
    }

    Board& core_;
    const sc_time sample_time_;
    const std::uint64_t turns_per_sample_;
    sc_core::sc_event wanted_changed_;
    std::uint64_t wanted_ = 0;
    std::uint64_t pending_ = 0;  // asked of the core
    std::uint64_t late_samples_ = 0;
    std::vector<Sample> samples_;
};

class SystemcBoard : public Board {
  public:
    SystemcBoard(std::unique_ptr<Board> core, const SystemTimes& times)
        : core_(std::move(core)),
          host_time_(seconds(times.host_s)),
          bus_("bus", seconds(times.word_s)),
          board_("board", *core_, times) {
        host_.bus.bind(bus_.host);
        bus_.board.bind(board_.bus);
        sc_core::sc_start(sc_core::SC_ZERO_TIME);  // every thread waits for its event
    }

    std::size_t write(Stream stream, const std::uint64_t* words, std::size_t count) override {
        return host_.write(stream == Stream::kSegments ? kSegmentWords : kProfileWords, words,
                           count);
    }
    bool arrived(Stream stream) const override { return core_->arrived(stream); }
    bool full(Stream stream) const override { return core_->full(stream); }
    bool paced() const override { return true; }
    void request(std::uint64_t samples) override { host_.write(kRequest, &samples, 1); }

    void work(std::vector<Sample>& samples) override {
        sc_core::sc_start(host_time_);
        std::vector<Sample>& came = board_.samples();
        samples.insert(samples.end(), came.begin(), came.end());
        came.clear();
    }

    BoardStatus status() const override {
        BoardStatus status = core_->status();
        status.late_samples = board_.late_samples();
        return status;
    }

  private:
    std::unique_ptr<Board> core_;
    const sc_time host_time_;
    HostPort host_{"host"};
    Bus bus_;
    TimedBoard board_;
};

}  // namespace

std::unique_ptr<Board> make_systemc_board(std::unique_ptr<Board> core, const SystemTimes& times) {
    return std::make_unique<SystemcBoard>(std::move(core), times);
}

}  // namespace curvecore::sysc

/// SystemC's library wants one; the program has a main() of its own.
int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
