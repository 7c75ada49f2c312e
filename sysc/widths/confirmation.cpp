// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/confirmation.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace curvecore::tb {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// What a command prints on stdout; its stderr is ours.
std::string output_of(const std::string& command, int& status) {
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw ConfirmationError("cannot start a shell");
    std::string text;
    std::array<char, 4096> part{};
    std::size_t count = 0;
    while ((count = fread(part.data(), 1, part.size(), pipe)) > 0) text.append(part.data(), count);
    const int ended = pclose(pipe);
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    return text;
}

std::string arguments(const Candidate& candidate, const Device& device) {
    const CoreParameters& p = candidate.parameters;
    std::string text = fmt::format(
        " --core {} --build {} --device {} --set Order={} --set CoefBits={} --set PositionBits={} "
        "--set GuardBits={} --set Mode={}",
        core_name(candidate.core), build_name(p.build), device.name, p.order, p.coef_bits,
        p.position_bits, p.guard_bits, p.mode);
    if (p.build == Build::kParallel)
        text += fmt::format(" --set SampleInterval={}", p.sample_interval);
    if (p.turn_bits > 0) text += fmt::format(" --set TurnBits={}", p.turn_bits);
    if (p.parameter_guard > 0) text += fmt::format(" --set ParameterGuard={}", p.parameter_guard);
    return text;
}

}  // namespace

Confirmation place_and_route(const Candidate& candidate, const Device& device) {
    const char* const other = std::getenv("CURVECORE_SYNTH");
    const fs::path script = other != nullptr ? other : CURVECORE_SOURCE "/scripts/synth.sh";
    if (!fs::exists(script)) {
        throw ConfirmationError(
            fmt::format("{} is not there: --confirm needs the source tree, or CURVECORE_SYNTH",
                        script.string()));
    }
    int status = 0;
    const std::string text =
        output_of(quoted(script.string()) + arguments(candidate, device), status);
    if (status != 0) {
        throw ConfirmationError(fmt::format("{} failed with status {}: see its messages above",
                                            script.string(), status));
    }
    // The row ends with "; FILE", relative to the tree.
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t mark = text.rfind("; ", end);
    if (end == std::string::npos || mark == std::string::npos) {
        throw ConfirmationError(fmt::format("{} printed no row", script.string()));
    }
    const fs::path file = fs::path(CURVECORE_SOURCE) / text.substr(mark + 2, end - mark - 1);
    std::ifstream stream(file);
    try {
        const auto json = nlohmann::json::parse(stream);
        return {json.at("lut4"), json.at("ff"),   json.at("fmax_mhz"),
                json.at("dsp"),  json.at("bram"), json.at("seeds")};
    } catch (const nlohmann::json::exception&) {
        throw ConfirmationError(
            fmt::format("{} is not a result of place and route", file.string()));
    }
}

}  // namespace curvecore::tb
