// SPDX-License-Identifier: Apache-2.0
// Bound of the distance between the words of a power series (ref/curves/series.net) and it.
#pragma once

#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// Bound of each axis in a step of 2^k length units, before the final rounding: of all series whose
/// slope keeps the words' range, since a table without products rounds alike whatever is drawn.
/// @param core its table is one of a series; the last core's bounds are kept, for all threads
double series_error(const CoreParameters& core, int k);

/// Longest step whose bound is at most `limit`, as its exponent k; -1: there is none.
int longest_series_step(const CoreParameters& core, double limit);

}  // namespace curvecore::ref
