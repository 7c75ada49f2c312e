// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_reader.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "ref/program/gcode_reader.hpp"
#include "ref/program/input_error.hpp"

namespace curvecore::ref {

Program read_program(const std::string& file, const PointsOptions& points) {
    std::string kind = std::filesystem::path(file).extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (kind == ".csv") {
        return read_points(file, points);
    }
    const std::set<std::string> known{".ngc", ".nc", ".gcode", ".tap"};
    if (known.count(kind) == 0) {
        throw InputError(file, 0, "unknown kind of file: .ngc .nc .gcode .tap .csv are read");
    }
    return read_gcode(file, points.fit_tolerance);
}

}  // namespace curvecore::ref
