// SPDX-License-Identifier: Apache-2.0
// `curvecore stream`: a program to a board at the other end of a wire.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "hls/registers/registers.h"
#include "ref/curve/axes.hpp"
#include "ref/machine/path_quantum.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/commands/board/commands.hpp"
#include "sysc/commands/board/stream_panel.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/output_folder.hpp"
#include "sysc/home/encoders.hpp"
#include "sysc/home/start_check.hpp"
#include "sysc/wire/wire_stream.hpp"

namespace curvecore::sysc {
namespace {

double mm_of(std::uint64_t quanta, double quantum_mm) {
    return static_cast<double>(quanta) * quantum_mm;
}

/// Words a second that the link carries; null where the rate is unknown, as for UDP.
nlohmann::ordered_json link_words(const RemoteMachine& machine) {
    if (machine.words_per_s() == 0) return nullptr;
    return machine.words_per_s();
}

/// Report of what was planned and of the board's state.
nlohmann::ordered_json report(const Options& options, const RemoteMachine& machine,
                              const WireStream& stream, const std::vector<std::int32_t>& steps,
                              const std::vector<Following>& following, double quantum_mm,
                              double seconds, const std::string& end) {
    const PlannedWords& planned = stream.planned();
    const LinkFigures link = machine.figures();
    const RemoteBuild& build = machine.build();
    nlohmann::ordered_json json;
    json["input"] = options.file;
    json["end"] = end;
    json["faults"] = fault_names(stream.faults());
    json["board"] = {{"axes", build.axes},
                     {"clock_hz", build.clock_hz},
                     {"sample_period_s", build.sample_period_s},
                     {"parameters", parameters_json(build.core)}};
    json["planned"] = {{"path_quanta", planned.path},
                       {"samples", planned.samples},
                       {"duration_s", static_cast<double>(planned.samples) * build.sample_period_s},
                       {"words", planned.words},
                       {"words_of_busiest_second", planned.busiest}};
    json["drawn"] = {{"path_quanta", stream.path()}, {"steps", steps}, {"held", stream.held()}};
    json["drawn"]["waits_mm"] = nlohmann::json::array();
    for (const std::uint64_t at : stream.waits()) {
        json["drawn"]["waits_mm"].push_back(mm_of(at, quantum_mm));
    }
    for (const Following& axis : following) {
        json["following_error_mm"][std::string(1, ref::kAxisLetters[axis.encoder.axis])] = {
            {"worst", axis.worst_mm}, {"end", axis.now_mm}};
    }
    json["link"] = {{"duration_s", seconds},
                    {"frames", link.frames},
                    {"repeated", link.repeated},
                    {"round_trip_s", link.round_trip_s},
                    {"words_per_s", link_words(machine)},
                    {"rate", stream.link_rate()}};
    return json;
}

/// @throws InputError: the whole program is to be drawn, and it waits for a person
void check_alone(const WordSource& words, const Options& options) {
    if (options.from_mm > 0 || words.first_wait() == 0) return;
    throw ref::InputError(options.file, words.first_wait(),
                          "the program waits for a person here, and nobody could say resume: keys "
                          "need a terminal; or give --control FILE, or --web");
}

struct StreamOptions {
    PartOptions part;
    WireOptions wire;
    std::string web;    // address of the page; empty: none
    bool rest = false;  // of the program that the board has under way
};

int stream_command(StreamOptions& asked) {
    const WireOptions& wire = asked.wire;
    Options options = asked.part.complete();
    options.quiet = options.quiet || options.json;
    const std::unique_ptr<Link> link = open_link(wire.to);
    try {
        RemoteMachine machine(*link);
        const RemoteBuild& build = machine.build();
        take_board(build, options);
        const ref::Machine described = machine_of(options);
        const double quantum_mm = ref::path_quantum_mm(described, options.unit_mm);
        Drives drives = drives_of(wire, build.axes);
        shape(described, build, drives);
        const InterruptGuard guard;
        if (asked.rest) options.from_mm += mm_of(machine.stand(), quantum_mm);
        options.gcode.obeyed.waits = true;
        options.live = true;
        WordSource words(options);
        const BoardSettings settings = words.settings();
        if (asked.rest) {
            check_rest(machine, words.start(), drives);
            if (!options.quiet) fmt::print(stderr, "rest --from {:.6f}mm\n", options.from_mm);
        }
        std::optional<StreamPanel> panel;
        panel.emplace(StreamPanel::Parts{options, drives, machine, words}, wire.control, asked.web);
        if (!panel->heard()) check_alone(words, options);
        machine.prepare(drives, options.unit_mm);
        const Encoders encoders(machine, options.machine, drives);
        check_start(machine, words.start(), drives, options.machine);
        keep_start(machine, words.start(), drives);
        machine.begin(settings,
                      static_cast<int>(std::ceil(wire.watchdog_s / build.sample_period_s)));
        panel->begin(encoders);
        RestPlan rest(words.options(), [&](const WordSource& planned) {
            check_rest(machine, planned.start(), drives);
        });
        WireStream stream(machine, words, panel->wishes(), options.override_percent / 100,
                          options.file == ref::kStandardInput ? nullptr : &rest);
        const WireClock::time_point begin = WireClock::now();
        std::string end = "drawn";
        int exit = 0;
        try {
            const StreamEnd seen = stream.run([&] {
                panel->turn(stream);
                InterruptGuard::check();
            });
            if (seen == StreamEnd::kFault) {
                end = "fault";
                exit = 1;
            } else if (seen != StreamEnd::kDone) {
                end = "stopped";
                exit = 130;
            }
        } catch (const BoardLost& lost) {
            throw BoardLost(fmt::format("{}; {}", lost.what(), panel->lose(stream)));
        } catch (const Interrupted&) {
            stream.stop();
            end = "stopped";
            exit = 130;
        } catch (...) {  // of planning
            stream.stop();
            machine.disable();
            machine.finish();
            throw;
        }
        panel->end(stream, end);
        const double seconds = std::chrono::duration<double>(WireClock::now() - begin).count();
        const std::vector<std::int32_t> steps = machine.steps();
        const std::vector<Following> following = encoders.following();
        const std::string astray = exit == 0 ? Encoders::astray(following) : "";
        if (!astray.empty()) exit = 1;
        machine.disable();
        machine.finish();
        panel.reset();
        const nlohmann::ordered_json json =
            report(options, machine, stream, steps, following, quantum_mm, seconds, end);
        if (!options.folder.empty()) {
            OutputFolder folder(options.folder);
            folder.write("report.json", json.dump(2) + "\n");
            folder.commit();
        }
        if (options.json) print_json(json);
        if (end == "fault")
            fmt::print(stderr, "the board stopped: {}\n", fault_names(stream.faults()));
        if (!options.quiet) {
            fmt::print(
                "{} {:.3f} of {:.3f} mm{}, steps {}, {} frames, {} repeated, round trip {:.2f} "
                "ms\n",
                end, mm_of(stream.path(), quantum_mm), mm_of(stream.planned().path, quantum_mm),
                stream.planned().all ? "" : " planned so far", fmt::join(steps, " "),
                machine.figures().frames, machine.figures().repeated,
                1e3 * machine.figures().round_trip_s);
            if (end == "stopped" && options.file != ref::kStandardInput) {
                fmt::print("the same command with --from {:.6f}mm{} draws the rest\n",
                           options.from_mm + mm_of(stream.path(), quantum_mm),
                           asked.rest ? " and without --rest" : "");
            }
            for (const Following& axis : following) {
                fmt::print("{}: worst following error {:.4f} mm\n",
                           ref::kAxisLetters[axis.encoder.axis], std::abs(axis.worst_mm));
            }
        }
        if (!astray.empty()) fmt::print(stderr, "{}\n", astray);
        if (!stream.waits().empty()) {
            fmt::print(stderr,
                       "{}: warning: waited for words at s = {:.3f} mm{}: the link was too slow or "
                       "lost too many frames; the path was kept\n",
                       wire.to, mm_of(stream.waits().front(), quantum_mm),
                       stream.waits().size() == 1
                           ? ""
                           : fmt::format(", and {} times more", stream.waits().size() - 1));
        }
        if (stream.link_rate() < 1) {
            fmt::print(
                stderr,
                "{}: warning: time went at {:.0f} %: the link carries {:.0f} words a second, "
                "and the program has up to {}; --holds bounds has fewer\n",
                wire.to, 100 * stream.link_rate(), machine.words_per_s(), stream.planned().busiest);
        }
        for (const std::string& warning : stream.words().warnings())
            fmt::print(stderr, "{}\n", warning);
        return exit;
    } catch (const BoardLost& lost) {
        fmt::print(stderr, "{}: {}\n", wire.to, lost.what());
        return 1;
    }
}

}  // namespace

void add_wire(CLI::App& command, WireOptions& wire) {
    begin_group(command, group::kBoard);
    Drives& drives = wire.drives;
    add_text(command, "--to", wire.to, "BOARD", kLinkNames)->required();
    add_value(command, "--steps-per-mm", drives.steps_per_mm, "LIST",
              "of the drives, one value or one an axis",
              list_of(within(plain_number, kAboveZero, kGreatest, "above 0")))
        ->default_val("400");
    const auto add = [&command](const char* name, double& time, const char* help) {
        return add_value(command, name, time, "TIME", help, duration_of);
    };
    add("--steplen", drives.steplen_s, "a pulse is so long")->default_val("2us");
    add("--stepspace", drives.stepspace_s, "and the pause behind it")->default_val("2us");
    add("--dirsetup", drives.dirsetup_s, "from a turn to the next pulse")->default_val("4us");
    add("--dirhold", drives.dirhold_s, "from a pulse to a turn")->default_val("4us");
    add("--watchdog", wire.watchdog_s, "silence of this program that is a hold; 0: none")
        ->default_val("500ms");
    add_text(command, "--control", wire.control, "FILE",
             "lines that are added to it are obeyed: hold, resume, override 50, stop, estop");
    command.footer(
        "Keys: h hold, r resume, + - override, s stop, e e-stop. Ctrl-C stops on the path. The\n"
        "program waits for resume at M0, M6 and M60.\n"
        "The axes stand where the program begins; of axes that are homed that is checked.");
}

void add_stream(CLI::App& app, int& status) {
    auto [command, asked] =
        add_command(app, status, "stream",
                    "FILE to a board at the other end of a wire: steps and turns", stream_command);
    add_input(command, asked.part)->required();
    add_planning(command, asked.part);
    add_override(command, asked.part);
    add_wire(command, asked.wire);
    add_text(command, "--web", asked.web, "[ADDRESS:]PORT",
             "serves a page that shows the machine, and asks it to hold, resume and stop: of this "
             "computer alone, unless an address is given; port 0: any free one");
    command.add_flag("--rest", asked.rest,
                     "the rest of FILE, which another stream, of these options, left on the board: "
                     "from where the axes stand; --from is that of such a stream, if it had one");
}

}  // namespace curvecore::sysc
