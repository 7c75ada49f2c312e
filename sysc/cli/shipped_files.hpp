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

}  // namespace curvecore::sysc
