// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/named_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;

void check_table_name(const ref::CurveTable& table) {
    for (const char* taken : {"line", "arc", "helix", "spline", "curve"}) {
        if (table.name != taken) continue;
        throw UsageError(
            fmt::format("the table {}: a program draws {}s without a table", table.file, taken));
    }
}

std::shared_ptr<const ref::CurveTable> named_table(const std::string& name) {
    fs::path file = name;
    if (file.extension() != ".net") {
        const fs::path folder = shipped_files().folder / "ref/curves";
        file = folder / (name + ".net");
        if (!fs::exists(file)) {
            std::vector<std::string> names;
            for (const auto& entry : fs::directory_iterator(folder)) {
                if (entry.path().extension() == ".net") names.push_back(entry.path().stem());
            }
            std::sort(names.begin(), names.end());
            throw UsageError(fmt::format("--curve '{}': it is FILE.net, or one of {}", name,
                                         fmt::join(names, ", ")));
        }
    }
    auto table = std::make_shared<ref::CurveTable>(ref::read_curve_table(file));
    check_table_name(*table);
    table->powers = ref::row_powers(*table);
    return table;
}

}  // namespace curvecore::sysc
