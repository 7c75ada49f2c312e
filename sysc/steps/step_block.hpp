// SPDX-License-Identifier: Apache-2.0
// A block from samples to step and direction pins: kernel or Verilated step generator. Both make
// the same changes at the same clocks.
#pragma once

#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "hls/step_axis.hpp"

namespace curvecore::sysc {

/// Bits of the step generator's positions and scales: the widest, which suit all cores.
constexpr int kStepFineBits = 44;
constexpr int kStepScaleBits = 56;
constexpr int kStepTimeBits = 16;

enum class Pin { kStep, kDirection };

/// A pin's level after a clock. Clocks are counted from the end of the first tick.
struct PinChange {
    std::uint64_t clock;
    int axis;
    Pin pin;
    bool level;

    bool operator==(const PinChange& other) const {
        return std::tie(clock, axis, pin, level) ==
               std::tie(other.clock, other.axis, other.pin, other.level);
    }
};

struct StepSetup {
    int axes = 3;
    int period_log2 = 13;
    std::int64_t scale = 0;  // 2^-16 steps in 2^kStepFineBits units
    hls::PulseTimes times;   // clocks
    double clock_s = 0;      // simulated time of a clock
};

/// Failures of an axis: a step was dropped, a sample was too far away.
struct StepFlags {
    bool overrun = false;
    bool refused = false;
};

class StepBlock {
  public:
    virtual ~StepBlock() = default;

    /// Advances by 2^period_log2 clocks, in which a sample is taken for the next period; null: none
    /// came. Appends the changes of pins, in the order of clocks and axes. The first sample sets
    /// the places of the axes.
    virtual void period(const std::int64_t* positions, std::vector<PinChange>& changes) = 0;
    virtual StepFlags flags(int axis) const = 0;
};

std::unique_ptr<StepBlock> make_kernel_steps(const StepSetup& setup);

/// Makes the Verilated block. @throws UsageError if no Verilated step generator of the program fits
std::unique_ptr<StepBlock> make_rtl_steps(const StepSetup& setup);

/// Makes the Verilated block as a module of SystemC: pins_steps.hpp.
std::unique_ptr<StepBlock> make_pins_steps(const StepSetup& setup);

}  // namespace curvecore::sysc
