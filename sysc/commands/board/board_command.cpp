// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/board/board_command.hpp"

#include <fmt/format.h>

#include <cinttypes>
#include <cstdio>
#include <optional>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/virtual/board_server.hpp"
#include "sysc/wire/wire_options.hpp"

namespace curvecore::sysc {

void add_board(CLI::App& command, BoardOptions& options) {
    command
        .add_option("--listen", options.listen, "where; port 27181 when left out, 0: any free one")
        ->type_name("ADDRESS[:PORT]")
        ->capture_default_str();
    command.add_flag(
        "--fast", options.fast,
        "each frame gives its clock 5 ms, and nothing else does; otherwise its clock is "
        "that of the wall");
    command
        .add_option("-o,--output", options.folder,
                    "folder for steps.csv: every step of its pins, written when it ends")
        ->type_name("DIR");
    command
        .add_option("--home", options.home,
                    "a home switch: steps from the start in which it is closed, as x=-9000..-300")
        ->type_name("AXIS=FROM..TO,..")
        ->delimiter(',');
    command.add_flag("--limits", options.limits, "the home switches are limit switches too");
    command
        .add_option("--slip", options.slip,
                    "an axis that slips: steps from the start that it does not make, as "
                    "x=1000..1040")
        ->type_name("AXIS=FROM..TO,..")
        ->delimiter(',');
    command.add_option("--lag", options.lag, "axes, as their encoders see them, are so late")
        ->type_name("TIME")
        ->capture_default_str();
    command.footer(
        "It ends when it is interrupted (Ctrl-C). Only then DIR is written: killed otherwise, it "
        "leaves "
        "what an earlier run left.");
}

namespace {

VirtualRange range_of(const char* option, const std::string& text) {
    VirtualRange one;
    char axis = 0;
    int end = 0;
    const int count =
        std::sscanf(text.c_str(), "%c=%" SCNd64 "..%" SCNd64 "%n", &axis, &one.from, &one.to, &end);
    one.axis = axis - 'x';
    if (count != 3 || text.begin() + end != text.end() || one.axis < 0 ||
        one.axis >= VirtualBoard::kAxes || one.from > one.to) {
        throw UsageError(fmt::format("{} {}: must be as x=-9000..-300, axes x y z", option, text));
    }
    return one;
}

}  // namespace

int board_command(const BoardOptions& options) {
    std::optional<OutputFolder> folder;
    std::optional<OutputFile> steps;
    if (!options.folder.empty()) {
        folder.emplace(options.folder);
        steps.emplace(*folder, "steps.csv");
        steps->write("clock,axis,direction\n");
    }
    std::uint64_t count = 0;
    BoardServerOptions served{options.listen, options.fast, {}};
    VirtualAxes& axes = served.axes;
    axes.limits = options.limits;
    axes.lag_s = duration_of("--lag", options.lag);
    for (const std::string& text : options.home) {
        axes.switches.push_back(range_of("--home", text));
    }
    for (const std::string& text : options.slip) axes.slips.push_back(range_of("--slip", text));
    BoardServer server(served, [&](const VirtualStep& step) {
        ++count;
        if (steps)
            steps->write(fmt::format("{},{},{}\n", step.clock, step.axis, step.back ? -1 : 1));
    });
    fmt::print("listening on {}: {} axes, clock {:g} MHz, a sample every {:g} us{}\n",
               server.where(), VirtualBoard::kAxes, VirtualBoard::kClockHertz / 1e6,
               std::exp2(VirtualBoard::kPeriodLog2) / VirtualBoard::kClockHertz * 1e6,
               options.fast ? ", 5 ms of it a frame" : "");
    std::fflush(stdout);
    const InterruptGuard guard;
    try {
        for (;;) {
            server.work();
            InterruptGuard::check();
        }
    } catch (const Interrupted&) {
    }
    if (folder) {
        steps->close();
        folder->commit();
    }
    fmt::print("{} steps in {:.3f} s of its clock", count,
               static_cast<double>(server.clocks()) / VirtualBoard::kClockHertz);
    if (!options.fast) fmt::print(", which held {:.1f} % of real time", 100 * server.pace());
    fmt::print("\n");
    return 0;
}

}  // namespace curvecore::sysc
