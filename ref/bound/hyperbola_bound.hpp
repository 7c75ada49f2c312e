// SPDX-License-Identifier: Apache-2.0
// Bound of the distance between a hyperbola's words and y = 1 / (k (t0 + t)): derived, not tuned.
#pragma once

#include "ref/format/parameters.hpp"

namespace curvecore::ref {

/// Errors of y, in the kernel's unit: of h / (t0 + t) for steps of h (hls/curves/hyperbola.hpp).
///
/// | field      | meaning                                                         |
/// |------------|-----------------------------------------------------------------|
/// | truncation | series cut after Order                                          |
/// | rounding   | the start word's half a last bit, and every rounding of a word  |
struct HyperbolaError {
    double truncation = 0;
    double rounding = 0;

    double total() const { return truncation + rounding; }
};

/// Bound of the errors at any time from the start of step `steps` to its end, the series evaluated
/// exactly; infinite where the words may have left the hyperbola altogether (Anchor = 0). `start`
/// is h / t0. Parameters read: Order, CoefBits, Anchor.
/// @throws std::domain_error unless 0 < start < 1/2
HyperbolaError hyperbola_error(const CoreParameters& format, double start, int steps);

}  // namespace curvecore::ref
