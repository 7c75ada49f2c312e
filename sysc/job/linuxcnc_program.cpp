// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/linuxcnc_program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "sysc/cli/shipped_files.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

using Target = ref::CanonicalMoves::Target;
using PathControl = ref::CanonicalMoves::PathControl;

ref::Vec3 vector(const nlohmann::json& list) {
    const auto values = list.get<std::array<double, 3>>();
    return {values[0], values[1], values[2]};
}

Target target(const nlohmann::json& call) {
    return {call.at("line"), call.at("to").get<ref::Point>(), call.value("feed", 0.0),
            call.at("kind") == "rapid"};
}

ref::Nurbs nurbs(const nlohmann::json& call) {
    ref::Nurbs curve;
    curve.order = call.at("order");
    curve.weights = call.at("weights").get<std::vector<double>>();
    for (const nlohmann::json& point : call.at("points")) curve.points.push_back(vector(point));
    return curve;
}

PathControl path_control(const std::string& mode) {
    if (mode == "exact stop") return PathControl::kExactStop;
    return mode == "exact path" ? PathControl::kExactPath : PathControl::kContinuous;
}

std::string last_line(const fs::path& file) {
    std::ifstream lines(file);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) last = line;
    }
    return last;
}

std::vector<std::string> with_arguments(std::vector<std::string> command, const std::string& file,
                                        const fs::path& scratch) {
    command.insert(command.end(), {file, "--scratch", scratch});
    return command;
}

}  // namespace

ScratchFolder::ScratchFolder() {
    std::string name = fs::temp_directory_path() / "curvecore.XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

LinuxcncProgram::LinuxcncProgram(std::vector<std::string> command, const std::string& file,
                                 double fit_tolerance)
    : interpreter_(with_arguments(std::move(command), file, scratch_.path()),
                   scratch_.path() / "stderr"),
      moves_(file, fit_tolerance) {}

bool LinuxcncProgram::read() {
    const std::optional<std::string> line = interpreter_.line();
    if (!line) refuse_end();
    ++lines_;
    try {
        return carry_out(nlohmann::json::parse(*line));
    } catch (const nlohmann::json::exception& error) {
        moves_.refuse(
            fmt::format("the interpreter's line {} is not understood: {}", lines_, error.what()),
            0);
    }
}

bool LinuxcncProgram::carry_out(const nlohmann::json& call) {
    const std::string kind = call.at("kind");
    if (kind == "end") return false;
    if (kind == "error") moves_.refuse(call.at("text"), call.at("line"));
    if (kind == "line" || kind == "rapid") {
        moves_.line(target(call));
    } else if (kind == "arc") {
        moves_.arc(target(call), vector(call.at("centre")), vector(call.at("normal")),
                   call.at("turns"));
    } else if (kind == "nurbs") {
        moves_.nurbs(target(call), nurbs(call));
    } else if (kind == "path") {
        moves_.set_path(path_control(call.at("mode")), call.at("tolerance"));
    } else if (kind == "dwell") {
        moves_.dwell(call.at("seconds"));
    } else if (kind == "stop") {
        moves_.stop();
    } else if (kind == "start") {
        moves_.start(call.at("at").get<ref::Point>());
    } else if (kind == "left out") {
        moves_.leave_out(call.at("code"), call.at("line"), call.value("value", 0.0));
    } else if (kind == "warning") {
        moves_.warn(call.at("text"), call.at("line"));
    } else {
        moves_.refuse(
            fmt::format("the interpreter's line {} is of an unknown kind, {}", lines_, kind), 0);
    }
    return true;
}

void LinuxcncProgram::refuse_end() {
    const std::string how = interpreter_.end();
    const std::string said = last_line(scratch_.path() / "stderr");
    moves_.refuse(fmt::format("LinuxCNC's interpreter ended before the program did: {}{}", how,
                              said.empty() ? "" : "; it says: " + said),
                  0);
}

std::unique_ptr<ref::MoveStream> open_linuxcnc(const std::string& file,
                                               const LinuxcncMachine& machine,
                                               double fit_tolerance) {
    const char* const other = std::getenv("CURVECORE_LINUXCNC");
    const fs::path own = shipped_files().folder / "sysc/linuxcnc/interpret.py";
    std::vector<std::string> command{other != nullptr && *other != 0 ? other : own.string()};
    if (!machine.ini.empty()) command.insert(command.end(), {"--ini", machine.ini});
    if (!machine.tools.empty()) command.insert(command.end(), {"--tools", machine.tools});
    return std::make_unique<LinuxcncProgram>(std::move(command), file, fit_tolerance);
}

}  // namespace curvecore::sysc
