// SPDX-License-Identifier: Apache-2.0
// A waveform of pins and axes: each change at its time.
#pragma once

#include <memory>
#include <string>
#include <systemc>
#include <vector>

#include "sysc/system/machine.hpp"

namespace curvecore::sysc {

class PinTrace : public sc_core::sc_module {
  public:
    /// Writes FILE.vcd. To be made before the simulation begins.
    PinTrace(const sc_core::sc_module_name& name, const std::string& file,
             const std::vector<std::string>& axes);
    /// Closes the waveform: nothing more is written.
    void close();

    /// Writes the changes of a sample period that begins now, and the places of the axes at its
    /// end.
    void play(const Machine& machine, const std::vector<PinChange>& changes);

  private:
    struct Axis {
        sc_core::sc_signal<bool> step;
        sc_core::sc_signal<bool> direction;
        sc_core::sc_signal<double> command;
        sc_core::sc_signal<double> place;
        sc_core::sc_signal<double> following_error;
    };

    void write();

    sc_core::sc_trace_file* file_;
    std::vector<std::unique_ptr<Axis>> axes_;
    std::vector<PinChange> changes_;
    std::uint64_t first_clock_ = 0;
    double clock_s_ = 0;
    sc_core::sc_event begins_;
};

}  // namespace curvecore::sysc
