// SPDX-License-Identifier: Apache-2.0
#include "sysc/cli/shipped_files.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

fs::path& told() {
    static fs::path folder;
    return folder;
}

}  // namespace

ShippedFiles shipped_files() {
    if (!told().empty()) return {told(), true};
    std::error_code error;
    const fs::path beside =
        fs::read_symlink("/proc/self/exe", error).parent_path().parent_path() / "share/curvecore";
    if (fs::exists(beside / "sysc", error)) return {beside, true};
    return {CURVECORE_SOURCE, false};
}

void ship_from(const fs::path& folder) { told() = folder; }

}  // namespace curvecore::sysc
