// SPDX-License-Identifier: Apache-2.0
// Bound of the distance between a spline segment's words and the exact curve: derived, not tuned.
#pragma once

#include "ref/bound/error_bound.hpp"
#include "ref/bound/spline_words.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// Errors per axis, in length units, before the final rounding, at any path length of the segment,
/// for Anchor = 1. (Anchor = 0 has no bound: its equations do not pull errors back.)
///
/// | field          | meaning                                                                 |
/// |----------------|-------------------------------------------------------------------------|
/// | truncation     | series cut after Order                                                  |
/// | rounding       | every rounding of words, weights, tau, lengths and positions            |
/// | along          | Euclidean part along the path: how far a sample is ahead or behind      |
/// | along_rounding | its part by rounding                                                    |
/// | shorten        | what must be shorter so that every word keeps its range and every step  |
/// |                | converges; unless it is kNothing the other fields are unknown           |
struct SplineError {
    double truncation = 0;
    double rounding = 0;
    double along = 0;
    double along_rounding = 0;
    Shorten shorten = Shorten::kNothing;

    double total() const { return truncation + rounding; }
};

constexpr double kAlongShare = 0.5;  // share of an error limit that may be along the path

/// Walks the segment's integration steps. Fields read: curve, step_exponent, length,
/// aux_advance. Stops early when something has to be shorter, when the error exceeds
/// `give_up`, or when its part along the path exceeds its share of that.
SplineError spline_error(const CoreParameters& format, const Segment& segment,
                         double give_up = kUnlimited);

}  // namespace curvecore::ref
