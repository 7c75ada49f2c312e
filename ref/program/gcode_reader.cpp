// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_reader.hpp"

#include <sstream>

#include "ref/moves/move_source.hpp"
#include "ref/program/gcode_stream.hpp"

namespace curvecore::ref {

Program read_gcode(const std::string& file, const GcodeOptions& options) {
    std::ifstream text = open_text_file(file);
    GcodeStream stream(text, file, options);
    return read_all(stream, file);
}

Program read_gcode_text(std::string_view text, const std::string& file_name,
                        const GcodeOptions& options) {
    std::istringstream lines{std::string(text)};
    GcodeStream stream(lines, file_name, options);
    return read_all(stream, file_name);
}

}  // namespace curvecore::ref
