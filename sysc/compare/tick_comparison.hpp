// SPDX-License-Identifier: Apache-2.0
// Comparison of a scheme that steps once a tick with the exact curve, at the ticks' ends.
#pragma once

#include "sysc/compare/comparison.hpp"
#include "sysc/compare/scheme.hpp"

namespace curvecore::sysc {

/// Draws every cubic of the program from its own start words, in five phases of the first tick.
/// Errors are distances of the drawn points from the exact ones of the same path length; `output`
/// is rounded to units, as a core's would be. A curve blows up where a value became infinite, a
/// word left its range, or a point is 1 m off: the row then has no figures.
/// `setting` gives Order and, with words, CoefBits.
/// @throws what progress throws
Row compare_ticks(const Subject& subject, const CoreParameters& setting, const TickScheme& ticks,
                  const std::function<void()>& progress);

/// Returns the number of ticks along all cubics of a program.
double ticks_of(const ref::Program& program, const TickScheme& ticks);

}  // namespace curvecore::sysc
