// SPDX-License-Identifier: Apache-2.0
// Modules of a design with their ports, from Verilator's XML, and whether a module of others has a
// core's ports.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace curvecore::sysc {

struct Port {
    std::string direction;  // input, output, inout
    int bits = 0;           // 0: no vector of bits
};

struct TopModule {
    std::string name;
    std::map<std::string, Port> ports;
    std::vector<std::string> parameters;  // names
};

/// Reads the modules that no other module has inside.
/// @throws std::runtime_error: the file is none of Verilator's
std::vector<TopModule> top_modules(const std::filesystem::path& xml);

/// Returns that module which has the most of the core's ports; it has one at least, or null.
const TopModule* likest(const std::vector<TopModule>& modules, const TopModule& core);

/// Returns what a module's ports lack of the core's, port by port; empty: nothing.
std::string lacking_ports(const TopModule& module, const TopModule& core);

}  // namespace curvecore::sysc
