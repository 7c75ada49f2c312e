// SPDX-License-Identifier: Apache-2.0
#include "sysc/cache/dut_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sysc/cache/build_tools.hpp"
#include "sysc/cache/dut_ports.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

using Flags = std::vector<std::string>;

// Verilator 5.006 makes wrong models of some flat files with its data flow graphs.
const Flags kOfOthers{"-Wno-lint", "-Wno-style", "-Wno-fatal", "--relative-includes", "-fno-dfg"};

void append(Flags& flags, const Flags& more) {
    flags.insert(flags.end(), more.begin(), more.end());
}

/// Writes a design's XML. Returns false if Verilator refuses it.
bool write_xml(const Flags& design, const fs::path& folder, const fs::path& log) {
    Flags command{"verilator", "--xml-only", "--prefix", "Vcore", "--Mdir", folder};
    append(command, design);
    return run_tool(command, log, folder.parent_path()) == 0;
}

/// Returns -GName=Value of those parameters that the module has.
Flags shared_parameters(const WantedCore& core, const TopModule& module) {
    Flags shared;
    for (const std::string& parameter : core.parameters) {
        const auto& names = module.parameters;
        const std::string name = parameter.substr(0, parameter.find('='));
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        shared.push_back("-G" + parameter);
    }
    return shared;
}

TopModule core_module(const WantedCore& core, const fs::path& work, const fs::path& log) {
    Flags flags = kOfOthers;
    append(flags, {"--top-module", core.top, "-F", core.rtl / "curvecore.f"});
    for (const std::string& parameter : core.parameters) flags.push_back("-G" + parameter);
    if (!write_xml(flags, work / "core", log)) {
        throw std::runtime_error(fmt::format("{}: {}", core.top, reason_in(log)));
    }
    for (TopModule& module : top_modules(work / "core/Vcore.xml")) {
        if (module.name == core.top) return module;
    }
    throw std::runtime_error(fmt::format("there is no module {}", core.top));
}

std::string names_of(const std::vector<TopModule>& modules) {
    std::string names;
    for (const TopModule& module : modules) names += (names.empty() ? "" : ", ") + module.name;
    return names;
}

}  // namespace

std::vector<std::string> dut_flags(const std::vector<std::string>& files) {
    Flags flags = kOfOthers;
    append(flags, files);
    return flags;
}

DutDesign find_dut(const std::vector<std::string>& files, const WantedCore& core,
                   const fs::path& work, const fs::path& log) {
    const std::string who = fmt::format("--dut {}", fmt::join(files, ", "));
    const TopModule wanted = core_module(core, work, log);
    const auto read = [&](const Flags& flags) {
        if (!write_xml(flags, work / "dut", log)) {
            throw UsageError(
                fmt::format("{}: {}; all of it: {}", who, reason_in(log), log.string()));
        }
        return top_modules(work / "dut/Vcore.xml");
    };
    std::vector<TopModule> tops = read(dut_flags(files));
    const TopModule* found = likest(tops, wanted);
    if (found == nullptr) {
        fs::remove(log);
        throw UsageError(fmt::format("{}: no module has a port of {}; at the top are: {}", who,
                                     core.top, names_of(tops)));
    }
    Flags flags{"--top-module", found->name};
    const Flags shared = shared_parameters(core, *found);
    append(flags, shared);
    append(flags, dut_flags(files));
    if (!shared.empty()) {
        tops = read(flags);
        found = likest(tops, wanted);
    }
    const std::string lacking = lacking_ports(*found, wanted);
    if (!lacking.empty()) {
        fs::remove(log);
        throw UsageError(
            fmt::format("{}: {} has not the ports of {}: {}", who, found->name, core.top, lacking));
    }
    return {found->name, flags};
}

}  // namespace curvecore::sysc
