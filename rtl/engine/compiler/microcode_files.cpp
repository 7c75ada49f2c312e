// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/microcode_files.hpp"

#include <fstream>
#include <stdexcept>

#include "rtl/engine/assembler/listing.hpp"

namespace curvecore::assembler {

MicrocodeFiles microcode_files(const Assembly& assembly) {
    return {{"program.hex", program_hex(assembly)}, {"data.hex", data_hex(assembly)}};
}

void write_files(const MicrocodeFiles& files, const std::filesystem::path& folder) {
    for (const auto& [name, text] : files) {
        std::ofstream stream(folder / name, std::ios::binary);
        stream << text << std::flush;
        if (!stream) throw std::runtime_error("cannot write " + (folder / name).string());
    }
}

}  // namespace curvecore::assembler
