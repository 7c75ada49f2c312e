// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/named_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "hls/registers/board_facts.h"
#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;

namespace {

fs::path shipped_folder() { return shipped_files().folder / "ref/curves"; }

/// Files of the tables that are shipped, in the order of their names.
std::vector<fs::path> shipped_tables() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(shipped_folder())) {
        if (entry.path().extension() == ".net") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

void check_table_name(const ref::CurveTable& table) {
    for (const char* taken : {"line", "arc", "helix", "spline", "curve"}) {
        if (table.name != taken) continue;
        throw UsageError(
            fmt::format("the table {}: a program draws {}s without a table", table.file, taken));
    }
}

std::string table_file(const std::string& option, const std::string& name) {
    if (fs::path(name).extension() == ".net") return name;
    const fs::path file = shipped_folder() / (name + ".net");
    if (fs::exists(file)) return file;
    std::vector<std::string> names;
    for (const fs::path& one : shipped_tables()) names.push_back(one.stem());
    throw UsageError(
        fmt::format("{} '{}': it is FILE.net, or one of {}", option, name, fmt::join(names, ", ")));
}

std::shared_ptr<const ref::CurveTable> named_table(const std::string& name) {
    auto table =
        std::make_shared<ref::CurveTable>(ref::read_curve_table(table_file("--curve", name)));
    check_table_name(*table);
    table->powers = ref::row_powers(*table);
    return table;
}

std::shared_ptr<const ref::CurveTable> numbered_table(std::uint32_t number) {
    for (const fs::path& file : shipped_tables()) {
        if (curvecore_table_number(ref::read_curve_table(file).text.c_str()) == number) {
            return named_table(file);
        }
    }
    return nullptr;
}

}  // namespace curvecore::sysc
