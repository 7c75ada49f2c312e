// SPDX-License-Identifier: Apache-2.0
// A command's result as JSON, for scripts: --json. The formats are those of sysc/formats.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace curvecore::sysc {

/// Adds --json.
inline void add_json(CLI::App& command, bool& json) {
    command.add_flag("--json", json,
                     "the result as JSON on stdout, and nothing else there: sysc/formats");
}

inline void print_json(const nlohmann::ordered_json& result) { fmt::print("{}\n", result.dump(2)); }

}  // namespace curvecore::sysc
