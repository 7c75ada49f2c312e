// SPDX-License-Identifier: Apache-2.0
// Tables beside the papers' claims: printed as Markdown, written as JSON for scripts/results.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace curvecore::tb {

using Cells = std::vector<std::string>;

struct Table {
    std::string name;
    std::string claim;
    Cells header;
    std::vector<Cells> rows;
};

inline void print(const Table& table) {
    const auto line = [](const Cells& cells) { fmt::print("| {} |\n", fmt::join(cells, " | ")); };
    fmt::print("\n{}:\n\n", table.claim);
    line(table.header);
    line(Cells(table.header.size(), "---"));
    for (const Cells& row : table.rows) line(row);
}

/// Writes {tables: {NAME: {claim, header, rows}}}; nothing if `path` is empty. Returns the exit
/// status.
inline int write_tables(const std::vector<Table>& tables, const std::string& path) {
    if (path.empty()) return 0;
    nlohmann::json json;
    for (const Table& table : tables) {
        json["tables"][table.name] = {
            {"claim", table.claim}, {"header", table.header}, {"rows", table.rows}};
    }
    std::ofstream file(path);
    file << json.dump(2) << "\n";
    file.close();
    if (file) return 0;
    fmt::print(stderr, "{}: error: cannot be written\n", path);
    return 1;
}

}  // namespace curvecore::tb
