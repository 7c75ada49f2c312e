// SPDX-License-Identifier: Apache-2.0
// The host's end of the bus. The host is outside the simulation, which runs while it waits.
#pragma once

#include "sysc/system/bus.hpp"

namespace curvecore::sysc {

class HostPort : public sc_core::sc_module {
  public:
    tlm_utils::simple_initiator_socket<HostPort> bus{"bus"};

    explicit HostPort(const sc_core::sc_module_name& name) : sc_module(name) {
        SC_HAS_PROCESS(HostPort);
        SC_THREAD(transact);
    }

    /// Writes word after word until one is refused, and returns the number of words taken.
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
        tlm::tlm_generic_payload payload;
        payload.set_write();
        payload.set_address(address_);
        payload.set_data_ptr(reinterpret_cast<unsigned char*>(&word));
        payload.set_data_length(sizeof word);
        payload.set_streaming_width(sizeof word);
        payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
        sc_core::sc_time time = sc_core::SC_ZERO_TIME;
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

}  // namespace curvecore::sysc
