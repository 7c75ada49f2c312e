// SPDX-License-Identifier: Apache-2.0
// [Obukhov]'s claims, measured: Simpson with Runge's rule, the search per tick.
#pragma once

#include "ref/numeric/tick_search.hpp"

namespace curvecore::ref {

/// Of random cubics in a cube of 10 mm: how often the rule stops although the length is off by more
/// than the tolerance, and the worst of these.
struct FalseStops {
    double share = 0;
    double worst = 0;  // mm
};
FalseStops false_stops(double tolerance, int first, int cubics);

/// A whole cubic, tick by tick of ds mm.
struct SearchRun {
    double mean = 0;  // iterations per tick
    int most = 0;
    double error = 0;  // mm: the worst distance along the path from where the tick should be
};
SearchRun search_run(const Cubic& cubic, SearchForm form, double tolerance, double ds);

/// The same in words of so many fraction bits.
struct WordRun {
    double products = 0;  // per sample
    double error = 0;     // mm
};
WordRun word_run(const Cubic& cubic, int fraction, double tolerance, double ds);

}  // namespace curvecore::ref
