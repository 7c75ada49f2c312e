// SPDX-License-Identifier: Apache-2.0
// How far the words of a spline segment may leave the exact curve: derived, not tuned.
#pragma once

#include <limits>

#include "ref/bound/error_bound.hpp"
#include "ref/bound/spline_words.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// Errors per axis, in length units, before the final rounding, at any path length of the segment,
/// for Anchor = 1. (Anchor = 0 has no bound: its equations do not pull errors back.)
///
/// | field          | meaning                                                                 |
/// |----------------|-------------------------------------------------------------------------|
/// | truncation     | series cut after Order                                                  |
/// | rounding       | every rounding of words, weights, tau, lengths and positions            |
/// | along          | Euclidean part along the path: a sample is so far ahead or behind       |
/// | along_rounding | of which rounding                                                       |
/// | shorten        | what has to be shorter for every word to keep its range and every step  |
/// |                | to converge; nothing, or the rest is unknown                            |
struct SplineError {
    double truncation = 0;
    double rounding = 0;
    double along = 0;
    double along_rounding = 0;
    Shorten shorten = Shorten::kNothing;

    double total() const { return truncation + rounding; }
};

constexpr double kAlongShare = 0.5;  // of an error limit: what may be along the path

/// Walks the segment's integration steps. Read from the segment: a, b, c, beta, lambda,
/// step_exponent, length, aux_advance. Stops early when something has to be shorter or above
/// `give_up`, along the path above its share of that.
SplineError spline_error(const CoreParameters& format, const Segment& segment,
                         double give_up = std::numeric_limits<double>::infinity());

}  // namespace curvecore::ref
