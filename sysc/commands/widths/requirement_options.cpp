// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/widths/requirement_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sysc/choose/candidate.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/core/board_file.hpp"
#include "sysc/job/options.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kLeastError = 1e-7;  // mm
constexpr double kMostLength = 1e5;   // mm

}  // namespace

void interpret(const RawRequirement& raw, ChooseOptions& options) {
    Requirement& requirement = options.requirement;
    if (raw.board.empty() == raw.device.empty()) {
        throw UsageError("--device or --board must be given, one of them");
    }
    requirement.error_mm = length("--error", raw.error, kLeastError, 10);
    if (raw.board.empty()) {
        requirement.device = device_of(raw.device);
        requirement.sample_period_s = 1 / frequency("--sample-rate", raw.sample_rate, 1, 1e9);
        if (!raw.clock.empty()) requirement.clock_hz = frequency("--clock", raw.clock, 1e3, 1e10);
    } else {
        const BoardFile board = read_board_file(raw.board);
        requirement.whole_board = true;
        requirement.device = find_device(board.device);
        if (requirement.device == nullptr) {
            throw UsageError(
                fmt::format("--board {}: there are no measured runs of its device yet", raw.board));
        }
        requirement.sample_period_s = *board.core.sample_period_s;
        requirement.clock_hz = board.core.clock_hz;
    }
    requirement.feed = speed("--feed", raw.feed);
    if (raw.radius.empty() && raw.length.empty()) {
        throw UsageError("--radius of arcs or --length of splines, or both, must be given");
    }
    if (!raw.radius.empty()) {
        requirement.radius_mm = length("--radius", raw.radius, 1e-3, kMostLength);
        requirement.least_radius_mm =
            raw.least_radius.empty()
                ? std::min(requirement.radius_mm, requirement.least_radius_mm)
                : length("--least-radius", raw.least_radius, 1e-4, requirement.radius_mm);
    }
    if (!raw.length.empty())
        requirement.length_mm = length("--length", raw.length, 1e-3, kMostLength);
    requirement.travel_mm = raw.travel.empty()
                                ? std::max(requirement.radius_mm, requirement.length_mm)
                                : length("--travel", raw.travel, 1e-3, kMostLength);
    if (!raw.unit.empty()) requirement.unit_mm = unit_of(raw.unit);
    requirement.host_words = quantity("--host-words", raw.host_words, {{"", 0}});
    if (!(requirement.host_words >= 1 && requirement.host_words <= 1e12)) {
        throw UsageError("--host-words must be in [1, 1e12] a second");
    }
    if (!raw.build.empty()) requirement.build = build_of(raw.build);
    if (!options.machine.empty()) requirement.machine = ref::read_machine(options.machine);
    if (!clock_is_known(*requirement.device)) {
        if (!requirement.clock_hz) throw UsageError(clock_unknown(*requirement.device));
        if (options.confirm) {
            throw UsageError(fmt::format("--confirm: nothing is placed for {}: leave it out",
                                         requirement.device->name));
        }
    }
    if (!cost_is_known(requirement)) {
        throw UsageError(fmt::format(
            "--{} {}: there are no measured runs{} for it yet",
            requirement.whole_board ? "board" : "device",
            requirement.whole_board ? std::string_view(raw.board) : requirement.device->name,
            raw.build.empty() ? "" : " of the " + raw.build + " build"));
    }
}

}  // namespace curvecore::sysc
