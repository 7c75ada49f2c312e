// SPDX-License-Identifier: Apache-2.0
// A part's file of any kind, read as a whole.
#pragma once

#include "ref/program/program_stream.hpp"

namespace curvecore::ref {

/// Reads a file as ProgramStream does. @throws InputError
Program read_program(const std::string& file, const PointsOptions& points,
                     const OpenProgram& open = {}, const GcodeOptions& gcode = {});

}  // namespace curvecore::ref
