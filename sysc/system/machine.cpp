// SPDX-License-Identifier: Apache-2.0
#include "sysc/system/machine.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "ref/numeric/step_crossings.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

/// Greatest n for which a sample period has 2^n clocks.
int period_log2(const MachineSetup& setup) {
    const int log2 = std::ilogb(setup.sample_s * setup.clock_hz * (1 + 1e-9));
    // Clocks of scaling, and of loading before it: rtl/pulse/step_generator.sv.
    const int clocks = setup.axes * (kStepFineBits + 7) + 4;
    if (log2 < 6 || log2 > 20 || clocks > 1 << log2) {
        throw UsageError(
            fmt::format("a sample period has 2^{} clocks; the step generator of {} axes works with "
                        "{} or more, and 2^20 at most",
                        log2, setup.axes, clocks));
    }
    return log2;
}

/// Scale in 2^-16 steps for 2^kStepFineBits units of fine positions.
std::int64_t scale_of(const MachineSetup& setup, double step_mm) {
    const double scale = std::ldexp(setup.fine_mm / step_mm, kStepFineBits + hls::kStepFraction);
    if (!(scale >= 1 && scale < std::ldexp(1.0, kStepScaleBits - 1))) {
        throw UsageError(fmt::format(
            "--system step: {:g} mm are beyond the scales of the step generator", step_mm));
    }
    return std::llround(scale);
}

int clocks_of(double time, double clock_s) {
    const double clocks = std::ceil(time / clock_s - 1e-9);
    // The hardware counts two of them together.
    if (clocks >= 1 << (kStepTimeBits - 1)) {
        throw UsageError(
            fmt::format("--system: a pin's time of {:g} us is beyond the {} clocks that the step "
                        "generator counts",
                        time * 1e6, (1 << (kStepTimeBits - 1)) - 1));
    }
    return static_cast<int>(clocks);
}

StepSetup step_setup(const MachineSetup& setup, const SystemSettings& settings) {
    StepSetup steps;
    steps.axes = setup.axes;
    steps.period_log2 = period_log2(setup);
    steps.scale = scale_of(setup, settings.step_mm);
    const double clock_s = std::ldexp(setup.sample_s, -steps.period_log2);
    steps.clock_s = clock_s;
    steps.times.steplen = clocks_of(settings.pins.steplen, clock_s);
    steps.times.stepspace = clocks_of(settings.pins.stepspace, clock_s);
    steps.times.dirsetup = clocks_of(settings.pins.dirsetup, clock_s);
    steps.times.dirhold = clocks_of(settings.pins.dirhold, clock_s);
    return steps;
}

std::unique_ptr<StepBlock> make_steps(StepsKind kind, const StepSetup& setup) {
    switch (kind) {
        case StepsKind::kRtl:
            return make_rtl_steps(setup);
        case StepsKind::kPins:
            return make_pins_steps(setup);
        case StepsKind::kKernel:
            break;
    }
    return make_kernel_steps(setup);
}

}  // namespace

Machine::Machine(const MachineSetup& setup, const SystemSettings& settings) {
    const StepSetup steps = step_setup(setup, settings);
    scale_ = steps.scale;
    period_clocks_ = std::uint64_t(1) << steps.period_log2;
    clock_s_ = steps.clock_s;
    steps_ = make_steps(settings.steps, steps);
    const DriveAxis drive(settings.axis, settings.step_mm, setup.sample_s);
    axes_.assign(static_cast<std::size_t>(setup.axes), {drive, {}});
}

const std::vector<PinChange>& Machine::period(const Sample* sample) {
    changes_.clear();
    first_clock_ = next_clock_;
    next_clock_ += period_clocks_;
    steps_->period(sample != nullptr ? sample->fine.data() : nullptr, changes_);
    for (const PinChange& change : changes_) note(change);
    for (std::size_t a = 0; a < axes_.size(); ++a) {
        Axis& axis = axes_[a];
        axis.drive.advance();
        if (sample == nullptr) continue;
        axis.last = sample->fine[a];
        if (!begun_) axis.first = axis.last;
    }
    begun_ = begun_ || sample != nullptr;
    return changes_;
}

void Machine::note(const PinChange& change) {
    Axis& axis = axes_[static_cast<std::size_t>(change.axis)];
    const bool is_step = change.pin == Pin::kStep;
    axis.level[is_step ? 0 : 1] = change.level;
    const bool back = axis.level[1];
    if (is_step && change.level) {
        axis.drive.step(back);
        ++axis.status.steps;
        axis.status.count += back ? -1 : 1;
    }
    if (!is_step) ++axis.status.turns;
    const std::array<std::uint64_t, 2> words{
        change.clock,
        static_cast<std::uint64_t>(change.axis * 4 + (is_step ? 2 : 0)) + (change.level ? 1 : 0)};
    for (const std::uint64_t word : words) {
        for (int byte = 0; byte < 8; ++byte) {
            digest_ = (digest_ ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3;
        }
    }
}

StepStatus Machine::status() const {
    const auto step_at = [this](std::int64_t position) {
        const ref::StepCrossings places(1, std::int64_t(1) << hls::kStepFraction);
        return places.count(hls::place(position, scale_, kStepFineBits));
    };
    StepStatus all{1 / clock_s_, digest_, {}};
    for (std::size_t a = 0; a < axes_.size(); ++a) {
        const Axis& axis = axes_[a];
        AxisStatus status = axis.status;
        status.due = step_at(axis.last) - step_at(axis.first);
        status.following_error_mm = axis.drive.worst_following_error();
        const StepFlags flags = steps_->flags(static_cast<int>(a));
        status.overrun = flags.overrun;
        status.refused = flags.refused;
        all.axes.push_back(status);
    }
    return all;
}

}  // namespace curvecore::sysc
