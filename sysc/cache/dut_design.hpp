// SPDX-License-Identifier: Apache-2.0
// A design of others in the place of a core: which of its modules has a core's ports.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace curvecore::sysc {

/// A core as the program would make it.
struct WantedCore {
    std::filesystem::path rtl;            // folder of its sources
    std::string top;                      // module
    std::vector<std::string> parameters;  // Name=Value
};

struct DutDesign {
    std::string top;
    std::vector<std::string> flags;  // of Verilator: its parameters, and files
};

/// Verilator's flags for files of others: their warnings are theirs, and an include lies beside the
/// file that names it.
std::vector<std::string> dut_flags(const std::vector<std::string>& files);

/// Finds the module that has the core's ports, and those of the core's parameters that it has, too.
/// @param work folder for Verilator's files, which has none of a design
/// @param log what Verilator says
/// @throws UsageError: files that Verilator refuses; no module has these ports
DutDesign find_dut(const std::vector<std::string>& files, const WantedCore& core,
                   const std::filesystem::path& work, const std::filesystem::path& log);

}  // namespace curvecore::sysc
