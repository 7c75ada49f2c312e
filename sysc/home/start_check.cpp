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
        const double scale = drives.steps_per_mm[axis];
        if (std::abs(*places[axis] - start[axis] * scale) <= kSameStep) continue;
        throw UsageError(fmt::format("{} stands at {:.6g} mm, and the program begins at {:.6g} mm",
                                     ref::kAxisLetters[axis], *places[axis] / scale, start[axis]));
    }
}

}  // namespace curvecore::sysc
