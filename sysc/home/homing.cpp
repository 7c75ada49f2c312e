// SPDX-License-Identifier: Apache-2.0
#include "sysc/home/homing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "hls/registers/registers.h"
#include "ref/curve/axes.hpp"

namespace curvecore::sysc {
namespace {

/// Greatest distance between the places where a switch opens and closes.
constexpr double kHysteresis = 5;  // mm

}  // namespace

Homing::Homing(RemoteMachine& machine, const Options& options, const Drives& drives,
               int watchdog_samples, WishQueue& wishes, std::function<void()> turn)
    : machine_(machine),
      options_(options),
      drives_(drives),
      watchdog_samples_(watchdog_samples),
      wishes_(wishes),
      turn_(std::move(turn)) {}

ref::Program Homing::line(int axis, double way_mm, double speed) const {
    ref::Move move;
    move.line = 1;
    move.feed = speed;
    ref::Program program;
    program.file = fmt::format("homing {}", ref::kAxisLetters[axis]);
    if (axis < 3) {
        move.end[axis] = way_mm;
    } else {
        move.aux_end[axis - 3] = way_mm;
        program.aux_axes = axis - 2;
    }
    program.moves.push_back(move);
    return program;
}

/// Drives a straight line from where the axis stands, as its travel is not known yet. Returns true
/// if the switch reached the wanted state. The machine stands, its queues are empty.
bool Homing::drive(int axis, double way_mm, double speed, Until until) {
    Options options = options_;
    options.exact_path = true;
    options.program = std::make_shared<const ref::HeldProgram>(
        ref::HeldProgram{line(axis, way_mm, speed), {}, {}});
    ref::Machine machine = machine_of(options);
    machine.kinematics = ref::TrivialKinematics();  // joints are driven as they are
    for (ref::AxisLimits& limits : machine.axis) {
        limits.min = -ref::kUnlimitedTravel;
        limits.max = ref::kUnlimitedTravel;
    }
    WordSource words(options, machine);
    machine_.begin(words.settings(), watchdog_samples_);
    if (until != Until::kEnd) machine_.wait_for_switch(axis, until == Until::kClosed);
    WireStream stream(machine_, words, wishes_, 1);
    StreamEnd end = StreamEnd::kStopped;
    try {
        end = stream.run(turn_);
    } catch (const BoardLost&) {
        throw;
    } catch (...) {
        stream.stop();
        throw;
    }
    if (end == StreamEnd::kFault) {
        throw HomingError(fmt::format("{}: the board stopped: {}", ref::kAxisLetters[axis],
                                      fault_names(stream.faults())));
    }
    if (end == StreamEnd::kStopped) throw HomingStopped();
    stream.stop();
    return machine_.is(CURVECORE_STATE_CAUGHT_MASK);
}

void Homing::seek(const AxisHome& axis, double speed, double reach_mm, Until until) {
    const double way = std::copysign(reach_mm, speed);
    if (drive(axis.axis, way, std::abs(speed), until)) return;
    throw HomingError(fmt::format(
        "{}: the home switch did not {} within {:g} mm {}", ref::kAxisLetters[axis.axis],
        until == Until::kClosed ? "close" : "open", reach_mm, speed > 0 ? "up" : "down"));
}

std::int32_t Homing::home(const AxisHome& axis) {
    const int n = axis.axis;
    const double steps_per_mm = drives_.steps_per_mm[n];
    machine_.forget_place(n);
    if (machine_.switch_closed(n)) seek(axis, -axis.search, axis.reach, Until::kOpen);
    seek(axis, axis.search, axis.reach, Until::kClosed);
    const bool closing = std::signbit(axis.search) == std::signbit(axis.latch);
    if (closing) seek(axis, -axis.search, axis.reach, Until::kOpen);
    const double beyond =
        std::abs(machine_.steps()[n] - machine_.caught_steps(n)) / steps_per_mm + kHysteresis;
    seek(axis, axis.latch, beyond, closing ? Until::kClosed : Until::kOpen);
    const std::int32_t place = machine_.caught_steps(n);
    const auto whole = [steps_per_mm](double mm) {
        return static_cast<std::int32_t>(std::lround(mm * steps_per_mm));
    };
    const std::int32_t origin = place - whole(axis.place);
    machine_.set_origin(n, origin);
    const std::int32_t way = origin + whole(axis.home) - machine_.steps()[n];
    if (way != 0) drive(n, way / steps_per_mm, std::abs(axis.search), Until::kEnd);
    return place;
}

}  // namespace curvecore::sysc
