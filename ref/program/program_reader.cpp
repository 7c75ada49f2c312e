// SPDX-License-Identifier: Apache-2.0
#include "ref/program/program_reader.hpp"

namespace curvecore::ref {

Program read_program(const std::string& file, const PointsOptions& points) {
    ProgramStream stream(file, points);
    Program program;
    program.file = stream.file();
    for (Move move; stream.next(move);) program.moves.push_back(move);
    program.aux_axes = stream.aux_axes();
    program.warnings = stream.warnings();
    return program;
}

}  // namespace curvecore::ref
