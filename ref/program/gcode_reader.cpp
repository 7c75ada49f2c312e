// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_reader.hpp"

#include <sstream>

#include "ref/program/gcode_stream.hpp"

namespace curvecore::ref {
namespace {

Program read_all(std::istream& text, const std::string& file, double fit_tolerance) {
    GcodeStream stream(text, file, fit_tolerance);
    Program program;
    program.file = file;
    for (Move move; stream.next(move);) program.moves.push_back(move);
    program.aux_axes = stream.aux_axes();
    program.warnings = stream.warnings();
    return program;
}

}  // namespace

Program read_gcode(const std::string& file, double fit_tolerance) {
    std::ifstream text = open_text_file(file);
    return read_all(text, file, fit_tolerance);
}

Program read_gcode_text(std::string_view text, const std::string& file_name, double fit_tolerance) {
    std::istringstream stream{std::string(text)};
    return read_all(stream, file_name, fit_tolerance);
}

}  // namespace curvecore::ref
