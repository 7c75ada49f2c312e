// SPDX-License-Identifier: Apache-2.0
// Comparison of one configuration's words with the exact curve.
#pragma once

#include <functional>
#include <optional>

#include "sysc/compare/scheme.hpp"
#include "sysc/cost/cost_model.hpp"
#include "sysc/cost/multiplier_bits.hpp"
#include "sysc/curves/exact_samples.hpp"
#include "sysc/curves/position_count.hpp"
#include "sysc/curves/segmented_program.hpp"

namespace curvecore::sysc {

/// | field          | unit  | meaning                                                          |
/// |----------------|-------|------------------------------------------------------------------|
/// | output         | units | positions as they leave the core, rounded                        |
/// | fine           | units | positions before the final rounding                              |
/// | landing        | units | worst last position of a move less the move's own                |
/// | speed_error    | units | worst chord between samples less the exact curve's, unrounded    |
/// | speed_relative | 1     | speed_error by the chord, for chords of kSpeedChord units or more |
/// | bound          | units | derived, of any segment; none for splines with Anchor 0          |
/// | of_bound       | 1     | worst unrounded error / its segment's bound                      |
/// | steps          |       | integration steps                                                |
/// | missing_bits   |       | bits that a word of the networks lacks; above 0 it is no core    |
/// | cost           |       | on any device                                                    |
/// | estimate       |       | on Subject's device; none: no measured runs                      |
/// | ticks          |       | of a scheme that steps once a tick: then `steps` are ticks,      |
/// |                |       | `segments` curves, and there is no bound, landing or cost        |
/// | blow_ups       |       | curves that such a scheme has lost; if any, no figures           |
/// | by_move        | mm    | worst distance from the exact place of each move; infinite: lost |
struct Row {
    CoreParameters setting;
    std::optional<TickScheme> ticks;
    std::size_t blow_ups = 0;
    std::vector<double> by_move;
    double limit = 0;
    std::string refused;
    bool drawn = false;  // false: not drawable at all
    std::size_t segments = 0;
    std::uint64_t steps = 0;
    std::uint64_t samples = 0;
    PositionFigures output;
    PositionFigures fine;
    std::int64_t landing = 0;
    double speed_error = 0;
    std::optional<double> speed_relative;
    std::optional<double> bound;
    std::optional<double> of_bound;
    int missing_bits = 0;
    MultiplierBits cost;
    std::optional<CostEstimate> estimate;
    ValueRanges ranges{36};

    bool has_figures() const { return drawn && blow_ups == 0; }
    /// Returns true if the row is within the derived bound and every end is exact.
    bool held() const { return landing == 0 && of_bound.value_or(0) <= 1; }
};

/// Data that all configurations share.
struct Subject {
    const ref::Program& program;
    double unit_mm;
    bool arcs;  // false: lines
    bool splines;
    ExactSamples exact;
    const Device* device = nullptr;  // device of the cost estimate; null: no estimate
    bool by_move = false;            // Row::by_move is requested
};

/// Compares one configuration; `progress(n)` reports n more samples done.
/// @throws what progress throws
Row compare_setting(const Subject& subject, const CoreParameters& setting,
                    const SegmentedProgram& segmented,
                    const std::function<void(std::int64_t)>& progress);

}  // namespace curvecore::sysc
