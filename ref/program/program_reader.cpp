// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_reader.hpp"

#include "ref/moves/move_source.hpp"

namespace curvecore::ref {

Program read_program(const std::string& file, const PointsOptions& points, const OpenProgram& open,
                     const GcodeOptions& gcode) {
    ProgramStream stream(file, points, open, gcode);
    return read_all(stream, stream.file());
}

}  // namespace curvecore::ref
