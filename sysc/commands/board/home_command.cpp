// SPDX-License-Identifier: Apache-2.0
// `curvecore home`: drives the axes of a board's machine to their switches.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/curve/axes.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/board/commands.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/curves/named_table.hpp"
#include "sysc/home/encoders.hpp"
#include "sysc/home/homing.hpp"
#include "sysc/panel/console.hpp"

namespace curvecore::sysc {
namespace {

struct HomeOptions {
    Options options;
    WireOptions wire;
    std::string axes;  // empty: all that have a switch
};

/// Home settings of the machine's axes that were named.
std::vector<AxisHome> asked_homes(const std::string& axes, const std::string& machine,
                                  int board_axes) {
    std::vector<AxisHome> homes = read_homes(machine);
    std::string known;
    for (const AxisHome& home : homes) known += ref::kAxisLetters[home.axis];
    if (known.empty()) {
        throw UsageError(fmt::format("{} has no axis with HOME_SEARCH_VEL", machine));
    }
    for (const char letter : axes) {
        if (known.find(static_cast<char>(std::toupper(letter))) == std::string::npos) {
            throw UsageError(fmt::format("--axes {}: home switches are of {}", axes, known));
        }
    }
    const auto left_out = [&](const AxisHome& home) {
        const auto is = [&](char c) { return std::toupper(c) == ref::kAxisLetters[home.axis]; };
        return !axes.empty() && std::none_of(axes.begin(), axes.end(), is);
    };
    homes.erase(std::remove_if(homes.begin(), homes.end(), left_out), homes.end());
    for (const AxisHome& home : homes) {
        if (home.axis < board_axes) continue;
        throw UsageError(
            fmt::format("{}: the board has {} axes", ref::kAxisLetters[home.axis], board_axes));
    }
    return homes;
}

/// The limit switch that serves as the axis' home switch.
std::uint32_t limit_of(const AxisHome& home) { return home.ignore_limits ? 1U << home.axis : 0; }

int home_command(HomeOptions& asked) {
    const WireOptions& wire = asked.wire;
    Options options = asked.options;
    const std::unique_ptr<Link> link = open_link(wire.to);
    try {
        RemoteMachine machine(*link);
        const RemoteBuild& build = machine.build();
        take_board(build, options);
        const Drives drives = drives_of(wire, build.axes);
        const std::vector<AxisHome> homes = asked_homes(asked.axes, options.machine, build.axes);
        Console console(wire.control);
        WishQueue wishes;
        const InterruptGuard guard;
        machine.prepare(drives, options.unit_mm);
        const Encoders encoders(machine, options.machine, drives);
        Homing homing(machine, options, drives,
                      static_cast<int>(std::ceil(wire.watchdog_s / build.sample_period_s)), wishes,
                      [&] {
                          console.add_to(wishes, 100);
                          InterruptGuard::check();
                      });
        int exit = 0;
        nlohmann::ordered_json json{{"end", "homed"}, {"axes", nlohmann::json::array()}};
        // Any axis may stand on its limit switch until it is homed.
        std::uint32_t limits = 0;
        for (const AxisHome& home : homes) limits |= limit_of(home);
        try {
            for (const AxisHome& home : homes) {
                machine.ignore_limits(limits);
                const std::int32_t place = homing.home(home);
                limits &= ~limit_of(home);
                const char axis = ref::kAxisLetters[home.axis];
                json["axes"].push_back({{"axis", std::string(1, axis)},
                                        {"switch_step", place},
                                        {"switch_mm", home.place},
                                        {"home_mm", home.home}});
                if (options.quiet || options.json) continue;
                fmt::print("{}: its switch is at step {}, {:g} mm; it stands at {:g} mm\n", axis,
                           place, home.place, home.home);
            }
        } catch (const HomingError& error) {
            fmt::print(stderr, "{}\n", error.what());
            json["end"] = "failed";
            exit = 1;
        } catch (const HomingStopped&) {
            json["end"] = "stopped";
            exit = 130;
        } catch (const Interrupted&) {
            json["end"] = "stopped";
            exit = 130;
        }
        machine.ignore_limits(0);
        machine.disable();
        machine.finish();
        if (options.json) print_json(json);
        return exit;
    } catch (const BoardLost& lost) {
        fmt::print(stderr, "{}: {}\n", wire.to, lost.what());
        return 1;
    }
}

}  // namespace

void add_home(CLI::App& app, int& status) {
    auto [command, asked] = add_command(
        app, status, "home",
        "the axes of such a board's machine to their switches: where they stand is known",
        home_command);
    add_text(command, "--machine", asked.options.machine, "FILE.ini",
             "LinuxCNC's .ini: HOME_SEARCH_VEL, HOME_LATCH_VEL, HOME_OFFSET, HOME, "
             "HOME_SEQUENCE, HOME_IGNORE_LIMITS and the travel of [JOINT_n]")
        ->required();
    add_text(command, "--axes", asked.axes, "LETTERS", "of them, as zx; all when left out");
    add_value(command, "--curve", asked.options.core.table, "NAME",
              "the table that the board draws besides, if it is none of ref/curves: FILE.net",
              [](const std::string&, const std::string& text) { return named_table(text); });
    command.add_flag("-q,--quiet", asked.options.quiet, "print warnings and errors only");
    add_json(command, asked.options.json);
    add_wire(command, asked.wire);
    command.footer(
        "One axis after the other, Z first unless HOME_SEQUENCE says otherwise. Ctrl-C stops.");
}

}  // namespace curvecore::sysc
