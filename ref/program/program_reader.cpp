// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_reader.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <set>

#include "ref/program/gcode_reader.hpp"
#include "ref/program/input_error.hpp"

namespace curvecore::ref {

namespace {

std::string kind_of(const std::string& file) {
    std::string kind = std::filesystem::path(file).extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return kind;
}

}  // namespace

bool is_points_file(const std::string& file) { return kind_of(file) == ".csv"; }

Program read_program(const std::string& file, const PointsOptions& points) {
    if (file == kStandardInput) {
        const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
        return read_gcode_text(text, "stdin", points.fit_tolerance);
    }
    if (is_points_file(file)) {
        return read_points(file, points);
    }
    const std::set<std::string> known{".ngc", ".nc", ".gcode", ".tap"};
    if (known.count(kind_of(file)) == 0) {
        throw InputError(file, 0, "unknown kind of file: .ngc .nc .gcode .tap .csv are read");
    }
    return read_gcode(file, points.fit_tolerance);
}

}  // namespace curvecore::ref
