// SPDX-License-Identifier: Apache-2.0
// Where the files lie that the program takes along: sources of cores, scripts.
#pragma once

#include <filesystem>

namespace curvecore::sysc {

struct ShippedFiles {
    std::filesystem::path folder;  // laid out as the source tree
    bool installed = false;        // beside the program; else it is the source tree
};

ShippedFiles shipped_files();

}  // namespace curvecore::sysc
