// SPDX-License-Identifier: Apache-2.0
// A part's file, whatever its kind, to moves.
#pragma once

#include "ref/program/points_reader.hpp"

namespace curvecore::ref {

/// The name of the file that is read from standard input, as G-code.
constexpr const char* kStandardInput = "-";

/// Whether the extension is .csv, in upper or lower case.
bool is_points_file(const std::string& file);

/// By the extension, in upper or lower case: .ngc .nc .gcode .tap as G-code, .csv as points with
/// `points`; or kStandardInput. @throws InputError
Program read_program(const std::string& file, const PointsOptions& points);

}  // namespace curvecore::ref
