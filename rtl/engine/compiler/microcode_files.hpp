// SPDX-License-Identifier: Apache-2.0
// Files of all programs of a core, as rtl/motion_interpolator.sv takes them: program.hex and
// data.hex for $readmemh. Both belong together, so they are written together.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Texts by the names of their files.
using MicrocodeFiles = std::map<std::string, std::string>;

MicrocodeFiles microcode_files(const Assembly& assembly);

/// Writes each into a folder. @throws std::runtime_error naming the file that cannot be written
void write_files(const MicrocodeFiles& files, const std::filesystem::path& folder);

}  // namespace curvecore::assembler
