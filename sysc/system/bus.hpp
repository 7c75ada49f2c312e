// SPDX-License-Identifier: Apache-2.0
// The bus between host and board: each word takes a fixed time.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <systemc>

namespace curvecore::sysc {

/// Addresses of the board: words go to a stream's, the number of requested samples to kRequest.
enum Address : std::uint64_t { kSegmentWords = 0, kProfileWords = 8, kRequest = 16 };

inline sc_core::sc_time seconds(double time) { return sc_core::sc_time(time, sc_core::SC_SEC); }

class Bus : public sc_core::sc_module {
  public:
    tlm_utils::simple_target_socket<Bus> host{"host"};
    tlm_utils::simple_initiator_socket<Bus> board{"board"};

    explicit Bus(const sc_core::sc_module_name& name) : sc_module(name) {
        host.register_b_transport(this, &Bus::transport);
    }

    void set_word_time(double time) { word_time_ = seconds(time); }

  private:
    void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& time) {
        time += word_time_;
        board->b_transport(payload, time);
    }

    sc_core::sc_time word_time_;
};

}  // namespace curvecore::sysc
