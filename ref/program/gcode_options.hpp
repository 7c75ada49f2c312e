// SPDX-License-Identifier: Apache-2.0
// Options of the G-code reader.
#pragma once

#include <memory>
#include <optional>

#include "ref/curve/fit/cubic_fit.hpp"
#include "ref/curves/curve_table.hpp"
#include "ref/gcode/lines/dialect.hpp"
#include "ref/gcode/state/program_start.hpp"
#include "ref/moves/events.hpp"

namespace curvecore::ref {

struct GcodeOptions {
    double fit_tolerance = kFitTolerance;  // mm, for NURBS that are no cubics
    std::optional<Dialect> dialect;        // none: recognised from the program
    ProgramStart start;
    Obeyed obeyed{};
    std::shared_ptr<const CurveTable> table = {};  // of curves that comments name
};

}  // namespace curvecore::ref
