// SPDX-License-Identifier: Apache-2.0
#include "sysc/cache/core_microcode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

bool has(const fs::path& file, const std::string& text) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream found;
    found << stream.rdbuf();
    return stream && found.str() == text;
}

}  // namespace

CoreMicrocode::CoreMicrocode(const CoreParameters& parameters, const assembler::QueueWords& queues,
                             const fs::path& sources, int rate_bits) {
    if (parameters.build != Build::kEngine) return;
    try {
        files_ = assembler::microcode_files(
            assembler::motion_program(parameters, queues, sources.string(), rate_bits));
    } catch (const assembler::AssemblyError& error) {
        throw UsageError(fmt::format(
            "there is no engine with {}: {}{}", ref::parameters_text(parameters), error.what(),
            parameters.table ? "; a table needs less at a lower Order" : ""));
    }
}

std::string CoreMicrocode::text() const {
    std::string all;
    for (const auto& [name, text] : files_) all += text;
    return all;
}

void CoreMicrocode::write(const fs::path& folder) const { assembler::write_files(files_, folder); }

bool CoreMicrocode::lies_in(const fs::path& folder) const {
    return std::all_of(files_.begin(), files_.end(), [&folder](const auto& file) {
        return has(folder / file.first, file.second);
    });
}

}  // namespace curvecore::sysc
