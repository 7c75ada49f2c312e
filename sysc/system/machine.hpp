// SPDX-License-Identifier: Apache-2.0
// The machine that samples move: step generator, drives, axes.
//
//     samples -> StepBlock -> pins -> DriveAxis
//
// It advances once per sample period, ahead of the time of its pins.
#pragma once

#include <memory>
#include <vector>

#include "sysc/board/board.hpp"
#include "sysc/core/system_settings.hpp"
#include "sysc/steps/drive_axis.hpp"
#include "sysc/steps/step_block.hpp"

namespace curvecore::sysc {

/// Positions and clock of the core.
struct MachineSetup {
    int axes = 3;
    double fine_mm = 1e-6 / 1024;  // a unit of Sample::fine
    double sample_s = 100e-6;
    double clock_hz = 100e6;
};

class Machine {
  public:
    /// @throws UsageError: scale, times or clocks that the step generator does not support
    Machine(const MachineSetup& setup, const SystemSettings& settings);

    /// Advances by a sample period; null: its sample is late. Returns the changes of pins in it.
    const std::vector<PinChange>& period(const Sample* sample);

    StepStatus status() const;

    std::uint64_t first_clock() const { return first_clock_; }  // of the last period
    double clock_s() const { return clock_s_; }
    const DriveAxis& drive(std::size_t axis) const { return axes_[axis].drive; }

  private:
    struct Axis {
        DriveAxis drive;
        AxisStatus status;
        std::int64_t first = 0;  // samples, in units of fine positions
        std::int64_t last = 0;
        bool level[2] = {false, false};  // levels of the pins
    };

    void note(const PinChange& change);

    std::int64_t scale_;
    std::uint64_t period_clocks_;
    std::uint64_t first_clock_ = 0;
    std::uint64_t next_clock_ = 0;
    double clock_s_;  // period of the step generator's clock: 2^n a sample, at most the core's
    std::unique_ptr<StepBlock> steps_;
    std::vector<Axis> axes_;
    std::vector<PinChange> changes_;
    bool begun_ = false;
    std::uint64_t digest_ = 0xcbf29ce484222325;  // digest of all pins and times: FNV-1a
};

}  // namespace curvecore::sysc
