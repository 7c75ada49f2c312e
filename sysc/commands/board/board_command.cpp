// SPDX-License-Identifier: Apache-2.0
// `curvecore board`: a virtual board that listens.
#include <fmt/format.h>

#include <cinttypes>
#include <cstdio>
#include <optional>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/board/board_panel.hpp"
#include "sysc/commands/board/commands.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/curves/named_table.hpp"
#include "sysc/virtual/board_server.hpp"

namespace curvecore::sysc {

namespace {

struct BoardOptions {
    BoardServerOptions served{kWireAddress, false, {}, Build::kEngine, nullptr};
    std::string folder;  // empty: no files
    std::string web;     // empty: no page
    bool json = false;
};

VirtualRange range_of(const std::string& option, const std::string& text) {
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

int board_command(BoardOptions& options) {
    std::optional<OutputFolder> folder;
    std::optional<OutputFile> steps;
    std::optional<OutputFile> outputs;
    if (!options.folder.empty()) {
        folder.emplace(options.folder);
        steps.emplace(*folder, "steps.csv");
        steps->write("clock,axis,direction\n");
        outputs.emplace(*folder, "outputs.csv");
        outputs->write("clock,output,level\n");
    }
    std::optional<BoardPanel> panel;
    if (folder || !options.web.empty()) {
        options.served.axes.edge = [&](const VirtualEdge& edge) {
            if (panel) panel->see(edge);
            if (!outputs) return;
            const bool pwm = edge.output == VirtualBoard::kOutputs - 1;
            outputs->write(fmt::format("{},{},{}\n", edge.clock,
                                       pwm ? "pwm" : std::to_string(edge.output), edge.on ? 1 : 0));
        };
    }
    std::uint64_t count = 0;
    BoardServer server(options.served, [&](const VirtualStep& step) {
        ++count;
        if (steps)
            steps->write(fmt::format("{},{},{}\n", step.clock, step.axis, step.back ? -1 : 1));
    });
    const VirtualTimes& times = server.times();
    std::FILE* const said = options.json ? stderr : stdout;
    fmt::print(said, "listening on {}: {} axes, clock {:g} MHz, a sample every {:g} us{}\n",
               server.where(), VirtualBoard::kAxes, times.clock_hz / 1e6,
               std::exp2(times.period_log2) / times.clock_hz * 1e6,
               options.served.fast ? ", 5 ms of it a frame" : "");
    std::fflush(said);
    if (!options.web.empty()) panel.emplace(options.web, server, options.served.fast);
    const InterruptGuard guard;
    try {
        for (;;) {
            server.work();
            if (panel) panel->turn();
            InterruptGuard::check();
        }
    } catch (const Interrupted&) {
    }
    panel.reset();  // it uses the server
    if (folder) {
        steps->close();
        outputs->close();
        folder->commit();
    }
    if (options.json) {
        nlohmann::ordered_json pace;
        if (!options.served.fast) pace = server.pace();
        print_json({{"address", server.where()},
                    {"axes", VirtualBoard::kAxes},
                    {"clock_hz", times.clock_hz},
                    {"sample_period_s", std::exp2(times.period_log2) / times.clock_hz},
                    {"steps", count},
                    {"duration_s", static_cast<double>(server.clocks()) / times.clock_hz},
                    {"of_real_time", pace}});
        return 0;
    }
    fmt::print("{} steps in {:.3f} s of its clock", count,
               static_cast<double>(server.clocks()) / times.clock_hz);
    if (!options.served.fast) fmt::print(", which held {:.1f} % of real time", 100 * server.pace());
    fmt::print("\n");
    return 0;
}

}  // namespace

void add_board(CLI::App& app, int& status) {
    auto [command, options] = add_command(
        app, status, "board",
        "a virtual board that stream finds: the RTL of motion_board behind UDP", board_command);
    BoardServerOptions& served = options.served;
    add_text(command, "--listen", served.address, "ADDRESS[:PORT]",
             "where; port 27181 when left out, 0: any free one")
        ->capture_default_str();
    command.add_flag(
        "--fast", served.fast,
        "each frame gives its clock 5 ms, and nothing else does; otherwise its clock is "
        "that of the wall");
    add_value(command, "--build", served.build, "BUILD",
              "engine (default), a sample every 1600us, or parallel, every 100us; made with "
              "Verilator when it is first asked for",
              build_of);
    add_value(command, "--curve", served.table, "NAME",
              "a table that its engine draws besides, as stream asks for it: FILE.net, or one of "
              "ref/curves; series: joints of a machine",
              [](const std::string&, const std::string& text) { return named_table(text); });
    add_text(command, "-o,--output", options.folder, "DIR",
             "folder for steps.csv and outputs.csv: every step and edge of its pins, written when "
             "it ends");
    add_json(command, options.json);
    add_text(command, "--web", options.web, "[ADDRESS:]PORT",
             "a page that shows it in a browser, on 127.0.0.1; port 0: any free one");
    add_values(command, "--home", served.axes.switches, "AXIS=FROM..TO,..",
               "a home switch: steps from the start in which it is closed, as x=-9000..-300",
               range_of)
        ->delimiter(',');
    command.add_flag("--limits", served.axes.limits, "the home switches are limit switches too");
    add_values(command, "--slip", served.axes.slips, "AXIS=FROM..TO,..",
               "an axis that slips: steps from the start that it does not make, as x=1000..1040",
               range_of)
        ->delimiter(',');
    add_value(command, "--lag", served.axes.lag_s, "TIME",
              "axes, as their encoders see them, are so late", duration_of)
        ->default_val("0ms");
    command.footer(
        "It ends when it is interrupted (Ctrl-C). Only then DIR is written: killed otherwise, it "
        "leaves what an earlier run left.");
}

}  // namespace curvecore::sysc
