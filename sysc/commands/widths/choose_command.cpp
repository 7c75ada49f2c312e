// SPDX-License-Identifier: Apache-2.0
// `curvecore choose`: the smallest configuration that is proven to meet a requirement.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "sysc/choose/candidate.hpp"
#include "sysc/choose/choose_report.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/commands/widths/commands.hpp"
#include "sysc/core/board_file.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kImpossible = 3;  // exit status
constexpr std::size_t kListed = 5;
constexpr double kMostLength = 1e5;  // mm

struct ChooseOptions {
    Requirement requirement;
    std::string board;    // name or file, instead of device, sample rate and clock
    std::string folder;   // empty: no choose.json
    std::string machine;  // LinuxCNC's .ini; empty: the built-in one
    bool confirm = false;
    bool quiet = false;
    bool json = false;
};

/// Completes the requirement and checks it.
void complete(ChooseOptions& options) {
    Requirement& requirement = options.requirement;
    if (options.board.empty() == (requirement.device == nullptr)) {
        throw UsageError("--device or --board must be given, one of them");
    }
    if (!options.board.empty()) {
        if (options.confirm) {
            throw UsageError(
                "--confirm places a core, and no board: that is scripts/synth.sh --board");
        }
        const BoardFile board = read_board_file(options.board);
        requirement.whole_board = true;
        requirement.device = find_device(board.device);
        if (requirement.device == nullptr) {
            throw UsageError(fmt::format("--board {}: there are no measured runs of its device yet",
                                         options.board));
        }
        requirement.sample_period_s = *board.core.sample_period_s;
        requirement.clock_hz = board.core.clock_hz;
    }
    if (!requirement.arcs() && !requirement.splines()) {
        throw UsageError("--radius of arcs or --length of splines, or both, must be given");
    }
    if (requirement.arcs()) {
        requirement.least_radius_mm = std::min(requirement.radius_mm, requirement.least_radius_mm);
    }
    if (requirement.travel_mm == 0) {
        requirement.travel_mm = std::max(requirement.radius_mm, requirement.length_mm);
    }
    if (!options.machine.empty()) {
        requirement.machine = ref::read_machine(options.machine);
        refuse_joints(requirement.machine, "choose");
    }
    if (!clock_is_known(*requirement.device)) {
        if (!requirement.clock_hz) throw UsageError(clock_unknown(*requirement.device));
        if (options.confirm) {
            throw UsageError(fmt::format("--confirm: nothing is placed for {}: leave it out",
                                         requirement.device->name));
        }
    }
    if (!cost_is_known(requirement)) {
        const std::string build =
            requirement.build ? fmt::format(" of the {} build", build_name(*requirement.build))
                              : "";
        throw UsageError(fmt::format(
            "--{} {}: there are no measured runs{} for it yet",
            requirement.whole_board ? "board" : "device",
            requirement.whole_board ? std::string_view(options.board) : requirement.device->name,
            build));
    }
}

int choose_command(ChooseOptions& options) {
    complete(options);
    const InterruptGuard guard;
    std::optional<OutputFolder> folder;
    if (!options.folder.empty()) {
        folder.emplace(options.folder);
    } else if (options.confirm) {  // not committed
        folder.emplace((std::filesystem::temp_directory_path() / "curvecore-choose").string());
    }
    const auto begin = std::chrono::steady_clock::now();
    ChooseReport report{
        options.requirement, Chooser(options.requirement).smallest(kListed), {}, {}, 0};
    if (report.choices.empty()) {
        ProgressBar bar(100, options.quiet, ProgressBar::Counts::kParts);
        report.relaxations = relaxations(options.requirement, [&bar](int percent) {
            bar.update(static_cast<std::uint64_t>(percent));
        });
    }
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    bool held = true;
    if (folder && !report.choices.empty()) {
        folder->write("core.json", report.core().json().dump(2) + "\n");
    }
    if (options.confirm && !report.choices.empty()) {
        const Choice& winner = report.choices.front();
        try {
            report.confirmation = place_and_route(folder->path("core.json"));
        } catch (const ConfirmationError& error) {
            fmt::print(stderr, "curvecore: --confirm: {}\n", error.what());
            return 1;
        }
        const double needed =
            std::max(winner.need.least(), options.requirement.clock_hz.value_or(0));
        held = report.confirmation->mhz * 1e6 >= needed;
    }
    if (!options.folder.empty()) {
        folder->write("choose.json", report.json().dump(2) + "\n");
        folder->commit();
    }
    if (options.json) {
        print_json(report.json());
    } else if (!options.quiet) {
        fmt::print("{}", report.text());
    }
    if (report.choices.empty()) return kImpossible;
    if (!held) fmt::print(stderr, "curvecore: check failed: slower than the requirement needs\n");
    return held ? 0 : 1;
}

}  // namespace

void add_choose(CLI::App& app, int& status) {
    auto [command, options] = add_command(
        app, status, "choose",
        "the smallest core that is proven to keep an error at a feed in a device", choose_command);
    Requirement& asked = options.requirement;
    begin_group(command, "Requirement");
    add_value(command, "--error", asked.error_mm, "LENGTH",
              "worst error of a position on any axis, as the core gives it",
              in_range(length, 1e-7, 10))
        ->required();
    add_value(command, "--feed", asked.feed, "SPEED",
              "along the path, where acceleration lets it: 10m/min, 100mm/s", speed)
        ->required();
    CLI::Option* const board =
        add_text(command, "--board", options.board, "NAME",
                 "a motion_board with its UART on this board (scripts/boards) or a file of "
                 "yours: its device, clock and sample period; or instead --device");
    add_value(command, "--device", asked.device, "NAME", device_names(),
              [](const std::string&, const std::string& text) { return device_of(text); });
    add_value(command, "--radius", asked.radius_mm, "LENGTH",
              "largest radius of arcs and helices; lines come with them",
              in_range(length, 1e-3, kMostLength));
    add_value(command, "--least-radius", asked.least_radius_mm, "LENGTH",
              "smallest radius; 10um when left out",
              [&asked](const std::string& option, const std::string& text) {
                  return length(option, text, 1e-4, asked.arcs() ? asked.radius_mm : kMostLength);
              });
    add_value(command, "--length", asked.length_mm, "LENGTH", "longest spline",
              in_range(length, 1e-3, kMostLength));
    add_value(command, "--travel", asked.travel_mm, "LENGTH",
              "positions go so far to both sides; the largest radius or length when left out",
              in_range(length, 1e-3, kMostLength));
    add_value(command, "--unit", asked.unit_mm, "LENGTH",
              "length unit; the best of 1nm, 10nm, 0.1um and 1um when left out", unit_of);
    add_value(command, "--sample-rate", asked.sample_period_s, "FREQUENCY", "samples a second",
              [](const std::string& option, const std::string& text) {
                  return 1 / frequency(option, text, 1, 1e9);
              })
        ->default_val("10kHz")
        ->excludes(board);
    add_value(command, "--clock", asked.clock_hz, "FREQUENCY",
              "that the core must run at; any when left out", in_range(frequency, 1e3, 1e10))
        ->excludes(board);
    add_value(command, "--host-words", asked.host_words, "N",
              "words of 48 bits a second that the host can send",
              within(plain_number, 1, 1e12, "in [1, 1e12] a second"))
        ->default_val("100000");
    add_value(command, "--build", asked.build, "BUILD",
              "parallel or serial, of a board parallel or engine; either when left out", build_of);
    add_text(command, "--machine", options.machine, "FILE.ini",
             "acceleration and jerk from LinuxCNC's .ini");
    begin_group(command, group::kOutput);
    add_text(command, "-o,--output", options.folder, "DIR",
             "folder for choose.json, and core.json that --core takes");
    command
        .add_flag("--confirm", options.confirm,
                  "place and route the answer with scripts/synth.sh: minutes")
        ->excludes(board);
    command.add_flag("-q,--quiet", options.quiet, "print warnings and errors only");
    add_json(command, options.json);
    command.footer(
        "Exit status: 0 there is one; 1 --confirm failed or is too slow; 2 the command line is "
        "wrong; "
        "3 no core keeps the requirement, and the answer says what to give up.");
}

}  // namespace curvecore::sysc
