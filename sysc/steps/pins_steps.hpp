// SPDX-License-Identifier: Apache-2.0
// A step_generator as a SystemC module (verilator --sc) among signals, as a block.
//
//     period() --> signals: clk, samples --> step_generator --> signals: step, direction -->
//     changes
//
// period() lets simulated time pass: it is called by a thread of SystemC. A simulation that has
// begun accepts no further modules: a process has one such block, which lasts until it ends.
#pragma once

#include <algorithm>
#include <systemc>
#include <type_traits>

#include "sysc/steps/step_block.hpp"

namespace curvecore::sysc {

/// Binds a signal to a port, permanently.
template <class Port>
auto& signal_at(Port& port) {
    auto& signal = *new sc_core::sc_signal<typename Port::data_type>;
    port(signal);
    return signal;
}

/// The module and its signals.
template <class Model>
struct StepPins {
    template <class Port>
    using At = decltype(signal_at(std::declval<Port>()));

    explicit StepPins(const hls::PulseTimes& times) {
        // Unused here: levels, positions axis by axis, rates of others, a shaper, stops.
        signal_at(model.step_inverted_i);
        signal_at(model.direction_inverted_i);
        signal_at(model.by_axis_i);
        signal_at(model.axis_o);
        signal_at(model.position_i);
        signal_at(model.begins_i);
        signal_at(model.rates_read_o);
        signal_at(model.rates_i);
        signal_at(model.shaper_write_i);
        signal_at(model.shaper_i);
        signal_at(model.settled_o);
        signal_at(model.estop_i);
        signal_at(model.estop_o);
        signal_at(model.limit_i);
        signal_at(model.limit_o);
        signal_at(model.limit_masked_i);
        signal_at(model.stop_i);
        signal_at(model.rise_o);
        signal_at(model.back_o);
        signal_at(model.referenced_o);
        signal_at(model.uncertain_o);
        signal_at(model.late_o);
        signal_at(model.steplen_i).write(static_cast<unsigned>(times.steplen));
        signal_at(model.stepspace_i).write(static_cast<unsigned>(times.stepspace));
        signal_at(model.dirsetup_i).write(static_cast<unsigned>(times.dirsetup));
        signal_at(model.dirhold_i).write(static_cast<unsigned>(times.dirhold));
    }

    Model model{"step_generator"};
    At<decltype(Model::clk_i)> clk = signal_at(model.clk_i);
    At<decltype(Model::rst_ni)> rst_n = signal_at(model.rst_ni);
    At<decltype(Model::scale_write_i)> scale_write = signal_at(model.scale_write_i);
    At<decltype(Model::scale_axis_i)> scale_axis = signal_at(model.scale_axis_i);
    At<decltype(Model::scale_i)> scale = signal_at(model.scale_i);
    At<decltype(Model::reference_i)> reference = signal_at(model.reference_i);
    At<decltype(Model::sample_valid_i)> sample_valid = signal_at(model.sample_valid_i);
    At<decltype(Model::sample_ready_o)> sample_ready = signal_at(model.sample_ready_o);
    At<decltype(Model::sample_i)> sample = signal_at(model.sample_i);
    At<decltype(Model::tick_o)> tick = signal_at(model.tick_o);
    At<decltype(Model::step_o)> step = signal_at(model.step_o);
    At<decltype(Model::direction_o)> direction = signal_at(model.direction_o);
    At<decltype(Model::overrun_o)> overrun = signal_at(model.overrun_o);
    At<decltype(Model::refused_o)> refused = signal_at(model.refused_o);
};

template <class Model>
class PinsSteps : public StepBlock {
  public:
    PinsSteps(const StepSetup& setup, int model_axes)
        : setup_(setup), model_axes_(model_axes), pins_(*new StepPins<Model>(setup.times)) {}

    void period(const std::int64_t* positions, std::vector<PinChange>& changes) override {
        if (!begun_) begin();
        if (positions != nullptr) offer(positions);
        from_ = sc_core::sc_time_stamp();
        const auto passes = [&](double clocks) {
            sc_core::wait(from_ + sc_core::sc_time(setup_.clock_s * clocks, sc_core::SC_SEC) -
                          sc_core::sc_time_stamp());
        };
        for (int n = 0; n < 1 << setup_.period_log2; ++n) {
            passes(n + 0.5);
            const bool taken = pins_.sample_valid.read() && pins_.sample_ready.read();
            pins_.clk.write(true);
            passes(n + 1);
            pins_.clk.write(false);
            if (taken) pins_.sample_valid.write(false);
            look(changes);
            ++clock_;
        }
    }

    StepFlags flags(int axis) const override {
        return {(pins_.overrun.read() >> axis & 1) != 0, (pins_.refused.read() >> axis & 1) != 0};
    }

  private:
    /// Resets and sets the scales, up to the end of the first tick, in zero simulated time.
    void begin() {
        pins_.rst_n.write(false);
        edge();
        edge();
        pins_.rst_n.write(true);
        for (int a = 0; a < model_axes_; ++a) {
            pins_.scale_write.write(true);
            pins_.scale_axis.write(static_cast<unsigned>(a));
            pins_.scale.write(static_cast<std::uint64_t>(setup_.scale));
            edge();
        }
        pins_.scale_write.write(false);
        pins_.reference.write((1U << model_axes_) - 1);
        edge();
        pins_.reference.write(0);
        while (!pins_.tick.read()) edge();
        edge();
        begun_ = true;
    }

    void edge() {
        for (const bool level : {true, false}) {
            sc_core::wait(sc_core::SC_ZERO_TIME);
            sc_core::wait(sc_core::SC_ZERO_TIME);  // lets outputs follow
            pins_.clk.write(level);
        }
        sc_core::wait(sc_core::SC_ZERO_TIME);
        sc_core::wait(sc_core::SC_ZERO_TIME);
    }

    void offer(const std::int64_t* positions) {
        auto sample = pins_.sample.read();
        for (int a = 0; a < setup_.axes; ++a) {
            const int low = a * kStepFineBits;
            sample.range(low + kStepFineBits - 1, low) = sc_dt::sc_int<64>(positions[a]);
        }
        pins_.sample.write(sample);
        pins_.sample_valid.write(true);
    }

    void look(std::vector<PinChange>& changes) {
        const unsigned step = pins_.step.read();
        const unsigned direction = pins_.direction.read();
        for (int a = 0; a < setup_.axes; ++a) {
            const auto note = [&](Pin pin, unsigned levels, unsigned before) {
                if (((levels ^ before) >> a & 1) == 0) return;
                changes.push_back({clock_, a, pin, (levels >> a & 1) != 0});
            };
            note(Pin::kStep, step, step_);
            note(Pin::kDirection, direction, direction_);
        }
        step_ = step;
        direction_ = direction;
    }

    StepSetup setup_;
    int model_axes_;
    StepPins<Model>& pins_;
    bool begun_ = false;
    sc_core::sc_time from_;  // begin of the period
    std::uint64_t clock_ = 0;
    unsigned step_ = 0;
    unsigned direction_ = 0;
};

}  // namespace curvecore::sysc
