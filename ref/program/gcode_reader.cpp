// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_reader.hpp"

#include "ref/program/interpreter.hpp"
#include "ref/program/text_file.hpp"

namespace curvecore::ref {

Program read_gcode(const std::string& file, double fit_tolerance) {
    return read_gcode_text(read_text_file(file), file, fit_tolerance);
}

Program read_gcode_text(std::string_view text, const std::string& file_name, double fit_tolerance) {
    Interpreter interpreter(file_name, fit_tolerance);
    TextLines lines(text);
    bool framed = false;
    bool begun = false;
    while (const std::optional<std::string_view> line = lines.next()) {
        const Place place{file_name, lines.number()};
        const Block block(*line, place);
        if (block.percent && begun) {
            if (framed) {
                break;
            }
            place.refuse("% ends a program that does not begin with %");
        }
        framed = framed || block.percent;
        begun = begun || block.percent || !block.empty();
        if (!block.percent && !interpreter.execute(block, place)) {
            break;
        }
    }
    return interpreter.finish();
}

}  // namespace curvecore::ref
