// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/pin_trace.hpp"

namespace curvecore::sysc {

PinTrace::PinTrace(const sc_core::sc_module_name& name, const std::string& file,
                   const std::vector<std::string>& axes)
    : sc_module(name), file_(sc_core::sc_create_vcd_trace_file(file.c_str())) {
    SC_HAS_PROCESS(PinTrace);
    sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
    file_->set_time_unit(1, sc_core::SC_PS);
    for (const std::string& axis : axes) {
        axes_.push_back(std::make_unique<Axis>());
        Axis& signals = *axes_.back();
        sc_core::sc_trace(file_, signals.step, axis + ".step");
        sc_core::sc_trace(file_, signals.direction, axis + ".direction");
        sc_core::sc_trace(file_, signals.command, axis + ".command");
        sc_core::sc_trace(file_, signals.place, axis + ".place");
        sc_core::sc_trace(file_, signals.following_error, axis + ".following_error");
    }
    SC_THREAD(write);
}

void PinTrace::close() {
    if (file_ == nullptr) return;
    sc_core::sc_close_vcd_trace_file(file_);
    file_ = nullptr;
}

void PinTrace::play(const Machine& machine, const std::vector<PinChange>& changes) {
    changes_ = changes;
    first_clock_ = machine.first_clock();
    clock_s_ = machine.clock_s();
    for (std::size_t a = 0; a < axes_.size(); ++a) {
        const DriveAxis& drive = machine.drive(a);
        axes_[a]->command.write(drive.command());
        axes_[a]->place.write(drive.place());
        axes_[a]->following_error.write(drive.following_error());
    }
    begins_.notify();
}

void PinTrace::write() {
    while (true) {
        wait(begins_);
        std::uint64_t clock = first_clock_;
        for (const PinChange& change : changes_) {
            const std::uint64_t clocks = change.clock - clock;
            if (clocks > 0) wait(sc_core::sc_time(clock_s_ * clocks, sc_core::SC_SEC));
            clock = change.clock;
            Axis& axis = *axes_[static_cast<std::size_t>(change.axis)];
            (change.pin == Pin::kStep ? axis.step : axis.direction).write(change.level);
        }
    }
}

}  // namespace curvecore::sysc
