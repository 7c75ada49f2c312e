// SPDX-License-Identifier: Apache-2.0
// Files that are shipped with the program: sources of cores, scripts.
#pragma once

#include <filesystem>

namespace curvecore::sysc {

struct ShippedFiles {
    std::filesystem::path folder;  // has the layout of the source tree
    bool installed = false;  // true: the files lie beside the program; false: in the source tree
};

ShippedFiles shipped_files();

/// Lets the files lie there: for a library, which is beside another program.
void ship_from(const std::filesystem::path& folder);

}  // namespace curvecore::sysc
