// SPDX-License-Identifier: Apache-2.0
// Errors of positions, counted axis by axis, along and across the path.
#pragma once

#include <algorithm>
#include <cmath>

#include "sysc/curves/error_figures.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::sysc {

/// Errors of positions in length units: axis by axis, and of X Y Z as a vector.
struct PositionFigures {
    std::array<ErrorFigures, kMostAxes> axis;
    ErrorFigures along;   // ahead of or behind the commanded path length
    ErrorFigures across;  // at right angles to the path

    /// Worst of any axis.
    double worst() const {
        double worst = 0;
        for (const ErrorFigures& figures : axis) worst = std::max(worst, figures.worst);
        return worst;
    }
};

struct PositionCount {
    std::array<ErrorCount, kMostAxes> axis;
    ErrorCount along;
    ErrorCount across;

    void add(const double* error, const double* tangent, int axes) {
        double square = 0;
        double forward = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
            axis[i].add(error[i]);
            if (i >= 3) continue;
            square += error[i] * error[i];
            forward += error[i] * tangent[i];
        }
        along.add(forward);
        across.add(std::sqrt(std::max(0.0, square - forward * forward)));
    }

    PositionFigures figures(int axes) const {
        PositionFigures figures;
        for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
            figures.axis[i] = axis[i].figures();
        }
        figures.along = along.figures();
        figures.across = across.figures();
        return figures;
    }
};

}  // namespace curvecore::sysc
