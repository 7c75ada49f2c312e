// SPDX-License-Identifier: Apache-2.0
#include "sysc/cores/core_microcode.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "rtl/engine/assembler/listing.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

constexpr const char* kProgram = "program.hex";
constexpr const char* kData = "data.hex";

bool has(const fs::path& file, const std::string& text) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream found;
    found << stream.rdbuf();
    return stream && found.str() == text;
}

void write_file(const fs::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text << std::flush;
    if (!stream) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

CoreMicrocode::CoreMicrocode(const CoreParameters& parameters, const assembler::QueueWords& queues,
                             const fs::path& sources) {
    if (parameters.build != Build::kEngine) return;
    try {
        const assembler::Assembly made =
            assembler::motion_program(parameters, queues, sources.string());
        program_ = assembler::program_hex(made);
        data_ = assembler::data_hex(made);
    } catch (const assembler::AssemblyError& error) {
        throw UsageError(fmt::format("there is no engine with {}: {}",
                                     ref::parameters_text(parameters), error.what()));
    }
}

void CoreMicrocode::write(const fs::path& folder) const {
    if (empty()) return;
    write_file(folder / kProgram, program_);
    write_file(folder / kData, data_);
}

bool CoreMicrocode::lies_in(const fs::path& folder) const {
    return empty() || (has(folder / kProgram, program_) && has(folder / kData, data_));
}

}  // namespace curvecore::sysc
