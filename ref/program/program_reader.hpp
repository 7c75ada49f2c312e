// SPDX-License-Identifier: Apache-2.0
// A part's file, whatever its kind, as a whole.
#pragma once

#include "ref/program/program_stream.hpp"

namespace curvecore::ref {

/// As ProgramStream reads it. @throws InputError
Program read_program(const std::string& file, const PointsOptions& points,
                     const OpenProgram& open = {}, const GcodeOptions& gcode = {});

}  // namespace curvecore::ref
