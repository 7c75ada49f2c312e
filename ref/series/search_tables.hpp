// SPDX-License-Identifier: Apache-2.0
// Measurement of [Obukhov]'s claims: Simpson with Runge's rule, the search per tick.
#pragma once

#include "ref/numeric/tick_search.hpp"

namespace curvecore::ref {

/// Wrong stops on random cubics in a cube of 10 mm: the number of those at which the length is off
/// by more than the tolerance, and the worst of them.
struct FalseStops {
    double share = 0;
    double worst = 0;  // mm
};
FalseStops false_stops(double tolerance, int first, int cubics);

/// A run over a whole cubic, tick by tick of ds mm.
struct SearchRun {
    double mean = 0;  // iterations per tick
    int most = 0;
    double error = 0;  // mm: largest distance along the path from the tick's true place
};
SearchRun search_run(const Cubic& cubic, SearchForm form, double tolerance, double ds);

/// The same run in words with a number of fraction bits.
struct WordRun {
    double products = 0;  // per sample
    double error = 0;     // mm
};
WordRun word_run(const Cubic& cubic, int fraction, double tolerance, double ds);

}  // namespace curvecore::ref
