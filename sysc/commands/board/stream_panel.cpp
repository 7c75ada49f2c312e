// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/board/stream_panel.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "hls/path_outputs.hpp"
#include "hls/registers/registers.h"
#include "ref/curve/axes.hpp"
#include "ref/machine/path_quantum.hpp"

namespace curvecore::sysc {

StreamPanel::StreamPanel(const Parts& parts, const std::string& control_file,
                         const std::string& web)
    : parts_(parts),
      described_(machine_of(parts.options)),
      quantum_mm_(ref::path_quantum_mm(described_, parts.options.unit_mm)),
      console_(control_file),
      terminal_(!parts.options.quiet) {
    if ((terminal_.on() || !web.empty()) && parts.options.file != ref::kStandardInput) {
        forecast_.emplace(parts.options);
    }
    if (web.empty()) return;
    page_.emplace(
        web, [this](std::size_t from) { return path().json(from); }, wishes_);
    const nlohmann::json hello{
        {"program", std::filesystem::path(parts.options.file).filename().string()},
        {"version", CURVECORE_PROGRAM_VERSION},
        {"command", "stream"}};
    page_->show("hello", hello.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    fmt::print("page: {}\n", page_->address());
    std::fflush(stdout);
}

/// Returns the whole path, or else what is planned of it for the board.
PlannedPath& StreamPanel::path() { return forecast_ ? forecast_->path() : parts_.words.path(); }

void StreamPanel::begin(const Encoders& encoders) {
    encoders_ = &encoders;
    begin_ = parts_.machine.steps();
}

void StreamPanel::turn(const WireStream& stream) {
    console_.add_to(wishes_, stream.override_percent());
    tell_wait(stream);
    tell_begin(stream);
    const WireClock::time_point now = WireClock::now();
    if (now < shown_ + PageServer::kPeriod || !(terminal_.on() || (page_ && page_->watched())))
        return;
    shown_ = now;
    show(status(stream));
}

/// Says once that the program waits; if nobody can make it go on, it stops.
void StreamPanel::tell_wait(const WireStream& stream) {
    const ref::PlannedWait* wait = stream.wait();
    const std::string before =
        std::exchange(wait_, wait == nullptr ? "" : fmt::format("{} {}", wait->line, wait->what));
    if (wait == nullptr || wait_ == before) return;
    if (!terminal_.on() || !heard()) {
        fmt::print(stderr, "{}:{}: waits at {:.3f} mm: {}; {}\n", parts_.options.file, wait->line,
                   mm_of(wait->place), wait->what,
                   heard() ? "resume goes on" : "nobody can say resume, so it stops");
    }
    if (!heard()) wishes_.push({Wish::Kind::kStop});
}

/// Says where the program goes on: --rest needs it, should this host be lost.
void StreamPanel::tell_begin(const WireStream& stream) {
    if (std::exchange(told_begin_, stream.begin()) == stream.begin()) return;
    if (!terminal_.on() && !parts_.options.quiet) {
        fmt::print(stderr, "goes on --from {}\n", from_text(stream.begin()));
    }
}

/// A place of the path, quanta, as --from takes it.
std::string StreamPanel::from_text(std::uint64_t path) const {
    return fmt::format("{:.6f}mm", parts_.options.from_mm + mm_of(path));
}

void StreamPanel::end(const WireStream& stream, const std::string& how) {
    if (!page_) return;
    PanelStatus last = status(stream);
    last.state = how;
    const bool again = how == "stopped" && parts_.options.file != ref::kStandardInput;
    if (again) last.rest = "--from " + from_text(stream.path());
    show(last);
}

std::string StreamPanel::lose(const WireStream& stream) {
    const std::string rest =
        "--rest" + (stream.begin() == 0 ? "" : " --from " + from_text(stream.begin()));
    std::string text = fmt::format(
        "it was {:.3f} mm along the path, line {}; a board that is still on holds there, and draws "
        "the rest with stream {}",
        mm_of(stream.path()), stream.words().path().at(stream.path()).line, rest);
    if (page_) {
        last_.state = "lost";
        last_.rest = rest;
        last_.faults = text;
        page_->show("status", panel_json(last_));
    }
    return text;
}

std::string StreamPanel::state(const WireStream& stream) const {
    const RemoteMachine& machine = parts_.machine;
    if (!machine.is(CURVECORE_STATE_ENABLED_MASK)) return "off";
    if (stream.wait() != nullptr) {
        const bool held = machine.is(CURVECORE_STATE_HOLDING_MASK);
        return fmt::format("{}waits for a person: {}", held ? "held, " : "", stream.wait()->what);
    }
    if (machine.is(CURVECORE_STATE_HOLDING_MASK)) {
        return machine.is(CURVECORE_STATE_STANDING_MASK) ? "held" : "holds";
    }
    return stream.waiting() ? "waits for words" : "runs";
}

double StreamPanel::mm_of(std::uint64_t quanta) const {
    return static_cast<double>(quanta) * quantum_mm_;
}

/// Returns the axes; of a machine with joints the tool's X Y Z before the joints, by their numbers.
std::vector<PanelAxis> StreamPanel::axes() const {
    std::vector<PanelAxis> axes;
    std::array<double, kBoardAxes> places{};
    const std::vector<std::int32_t> steps = parts_.machine.steps();
    const bool joints = !ref::is_trivial(described_.kinematics);
    for (std::size_t n = 0; n < steps.size(); ++n) {
        const double way = (steps[n] - begin_[n]) / parts_.drives.steps_per_mm[n];
        places[n] = parts_.words.start()[n] + way;
        const char name = joints && n < 3 ? static_cast<char>('0' + n) : ref::kAxisLetters[n];
        axes.push_back({name, places[n], std::nullopt});
    }
    for (const Following& axis : encoders_->now()) {
        axes[axis.encoder.axis].following_mm = axis.now_mm;
    }
    if (!joints) return axes;
    const ref::Vec3 tool =
        ref::tool_of(described_.kinematics, ref::Vec3(places[0], places[1], places[2]),
                     ref::Vec3(places[3], places[4], places[5]));
    for (int i = 2; i >= 0; --i) {
        axes.insert(axes.begin(), {ref::kAxisLetters[static_cast<std::size_t>(i)], tool[i], {}});
    }
    return axes;
}

PanelStatus StreamPanel::status(const WireStream& stream) {
    RemoteMachine& machine = parts_.machine;
    const RemoteBuild& build = machine.build();
    const PlannedWords& planned = stream.planned();
    const PathPlace place = stream.words().path().at(stream.path());
    const Telemetry& now = machine.telemetry();
    PanelStatus status;
    status.state = state(stream);
    status.axes = axes();
    status.path_mm = mm_of(stream.path());
    status.planned_mm = path().length_mm();
    status.all_planned = forecast_ ? forecast_->all() : planned.all;
    status.feed_mm_min = 60 * place.feed_mm_s * now.rate;
    status.rate_percent = 100 * now.rate;
    status.override_percent = stream.override_percent();
    const double left_s = path().time_s() - path().at(stream.path()).time_s;
    const double raised = forecast_ ? 1 : stream.words().raised();
    status.left_s = left_s * raised * 100 / status.override_percent;
    status.line = place.line;
    const int segments = build.counted_words(build.segment_queue_words);
    const int profile = build.counted_words(build.profile_queue_words);
    status.queues = {{"segments", segments - now.segment_room, segments},
                     {"profile", profile - now.profile_room, profile}};
    if (build.outputs > 0) {
        const std::uint32_t word = machine.outputs();
        status.outputs = {CURVECORE_FIELD(word, OUTPUTS_BITS),
                          CURVECORE_FIELD(word, OUTPUTS_POWER) / double{hls::kMostLevel}};
    }
    if (stream.begin() > 0) status.from = from_text(stream.begin());
    status.faults = fault_names(stream.faults());
    return status;
}

/// Notes what has changed.
void StreamPanel::log(const PanelStatus& status) {
    const auto note = [this](const std::string& text) {
        page_->note(fmt::format("{:%H:%M:%S} {}", fmt::localtime(std::time(nullptr)), text));
    };
    if (status.state != last_.state) {
        note(fmt::format("{}, {:.3f} mm, line {}", status.state, status.path_mm, status.line));
    }
    if (status.override_percent != last_.override_percent) {
        note(fmt::format("override {} %", status.override_percent));
    }
    if (status.faults != last_.faults && !status.faults.empty()) note(status.faults);
}

void StreamPanel::show(PanelStatus status) {
    terminal_.show(panel_lines(status, terminal_.columns()));
    if (page_) {
        page_->show("status", panel_json(status));
        log(status);
    }
    last_ = std::move(status);
}

}  // namespace curvecore::sysc
