// SPDX-License-Identifier: Apache-2.0
// Code that each configuration of a core is compiled for: its model MODEL as an AnyCore's. Included
// once in an executable.
#pragma once

#include MODEL_HEADER
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"
#include "tb/support/bench/any_core.hpp"

namespace curvecore::tb {

const CoreConfiguration& core_configuration() {
    static const CoreConfiguration core = read_configuration(CONFIGURATION);
    return core;
}

/// The model as an AnyCore's; `drive(ports, model)` and `observe(model, ports)` are found beside
/// Ports' model.
template <class Verilated, class Ports>
class CoreModel : public AnyCore<Ports>::Model {
  public:
    explicit CoreModel(int seed) : dut_(seed) {}

    void settle(Ports& ports) override {
        drive(ports, *dut_);
        dut_.settle();
        observe(*dut_, ports);
    }
    void tick(Ports& ports) override {
        drive(ports, *dut_);
        dut_.tick();
        observe(*dut_, ports);
    }
    uint64_t cycle() const override { return dut_.cycle(); }
    void limit_cycles(uint64_t limit) override { dut_.limit_cycles(limit); }

  private:
    sysc::ClockedDut<Verilated> dut_;
};

/// Reads the axes of a sample from the two ports that carry them side by side.
template <class Verilated, class Ports>
void observe_sample(const Verilated& model, Ports& ports) {
    ports.sample_valid_o = model.sample_valid_o != 0;
    if (!ports.sample_valid_o) return;
    const ref::CoreParameters& core = core_configuration().parameters;
    const int bits = core.position_bits;
    const int fine = bits + core.guard_bits;
    for (int axis = 0; axis < core.axes(); ++axis) {
        ports.sample_fine_o[axis] = sysc::signed_field(model.sample_fine_o, axis * fine, fine);
        ports.sample_position_o[axis] =
            sysc::signed_field(model.sample_position_o, axis * bits, bits);
    }
}

}  // namespace curvecore::tb
