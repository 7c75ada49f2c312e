// SPDX-License-Identifier: Apache-2.0
#include "sysc/home/start_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/curve/axes.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/home/home_settings.hpp"

namespace curvecore::sysc {
namespace {

/// Tolerance in steps: a program whose start is nearer begins where the machine stands.
constexpr double kSameStep = 0.501;

void check_axis(std::size_t axis, std::int32_t place, const std::array<double, kBoardAxes>& start,
                const Drives& drives, const char* begins) {
    const double scale = drives.steps_per_mm[axis];
    if (std::abs(place - start[axis] * scale) <= kSameStep) return;
    throw UsageError(fmt::format("{} stands at {:.6g} mm, and {} at {:.6g} mm",
                                 ref::kAxisLetters[axis], place / scale, begins, start[axis]));
}

}  // namespace

void check_start(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                 const Drives& drives, const std::string& machine_file) {
    const std::vector<std::optional<std::int32_t>> places = machine.places();
    if (!machine_file.empty()) {
        for (const AxisHome& home : read_homes(machine_file)) {
            const auto axis = static_cast<std::size_t>(home.axis);
            if (axis >= places.size() || places[axis]) continue;
            throw UsageError(fmt::format("{} is not homed: curvecore home --machine {}",
                                         ref::kAxisLetters[axis], machine_file));
        }
    }
    for (std::size_t axis = 0; axis < places.size(); ++axis) {
        if (!places[axis]) continue;
        check_axis(axis, *places[axis], start, drives, "the program begins");
    }
}

void keep_start(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                const Drives& drives) {
    std::vector<std::int32_t> now(static_cast<std::size_t>(machine.build().axes));
    for (std::size_t axis = 0; axis < now.size(); ++axis) {
        now[axis] = static_cast<std::int32_t>(std::lround(start[axis] * drives.steps_per_mm[axis]));
    }
    machine.keep_places(now);
}

void check_rest(RemoteMachine& machine, const std::array<double, kBoardAxes>& start,
                const Drives& drives) {
    const std::vector<std::int32_t> places = machine.kept_places();
    for (std::size_t axis = 0; axis < places.size(); ++axis) {
        check_axis(axis, places[axis], start, drives,
                   "this program would go on, which has to be of the same options, the --from of a "
                   "rest included,");
    }
}

}  // namespace curvecore::sysc
