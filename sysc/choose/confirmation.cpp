// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/confirmation.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace curvecore::sysc {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Runs a command and returns its stdout; its stderr is that of this program.
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

/// Path of scripts/synth.sh in the source tree in which this program was built.
fs::path synth_script() {
    if (const char* const other = std::getenv("CURVECORE_SYNTH")) return other;
    std::error_code error;
    fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    while (!fs::exists(folder / "scripts/synth.sh") && folder.has_relative_path()) {
        folder = folder.parent_path();
    }
    return folder / "scripts/synth.sh";
}

}  // namespace

Confirmation place_and_route(const std::string& core_file) {
    const fs::path script = synth_script();
    if (!fs::exists(script)) {
        throw ConfirmationError(fmt::format(
            "{} is not there: in the source tree, scripts/synth.sh --core {} does the same",
            script.string(), core_file));
    }
    int status = 0;
    const std::string text =
        output_of(quoted(script.string()) + " --core " + quoted(core_file), status);
    if (status != 0) {
        throw ConfirmationError(fmt::format("{} failed with status {}: see its messages above",
                                            script.string(), status));
    }
    // The row ends with "; FILE", relative to the working folder.
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t mark = text.rfind("; ", end);
    if (end == std::string::npos || mark == std::string::npos) {
        throw ConfirmationError(fmt::format("{} printed no row", script.string()));
    }
    const fs::path file = text.substr(mark + 2, end - mark - 1);
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

}  // namespace curvecore::sysc
