// SPDX-License-Identifier: Apache-2.0
// From moves to what a core is loaded with: the only place where geometry meets feed.
#pragma once

#include "ref/error_bound.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

/// | field                  | unit   | remark                                                     |
/// |------------------------|--------|------------------------------------------------------------|
/// | unit_mm                | mm     | the length unit                                            |
/// | sample_period_s        | s      |                                                            |
/// | samples_per_tick       | 1      | 2^n; a tick, the profile's clock, is so many samples       |
/// | format                 |        | word widths and order of the core                          |
/// | aux_axes               | 1      | auxiliary axes of the core; more in a program are refused  |
/// | error_limit            | units  | every segment's derived bound stays below it               |
/// | clock_hz               | Hz     | with the next: an integration step takes at least          |
/// | network_latency_clocks | clocks | latency / clock seconds, so short steps bound the speed    |
/// | spline_latency_clocks  | clocks | the same for steps of splines                              |
/// | max_pieces             | 1      | segments of one move; one that needs more is refused       |
/// | advise                 |        | a refusal says which width would do: takes many plans      |
struct PlanOptions {
    double unit_mm = 1e-6;
    double sample_period_s = 100e-6;
    int samples_per_tick = 1;
    WordFormat format;
    int aux_axes = kAuxAxes;
    double error_limit = 0.1;
    double clock_hz = 100e6;
    double network_latency_clocks = 200;
    double spline_latency_clocks = 400;
    int max_pieces = 1 << 16;
    bool advise = true;

    double tick_s() const { return sample_period_s * samples_per_tick; }
};

/// Segments and feed profile of a whole program.
///
/// Moves follow each other: moves[i].end is moves[i+1].start. A move without length makes no
/// segment; its exact_stop and dwell count. Where a cubic stands still (a cusp, a doubled control
/// point) the machine stops. Where an auxiliary axis runs faster than 1.9 units per
/// unit of X Y Z, the path length of the whole move is stretched: then |dr/ds| =
/// hypot(cos_pitch, |advance|) < 1 and the speed along s is larger than the feed in proportion; a
/// spline's path cannot be stretched.
///
/// @throws InputError with the move's line: beyond the travel or the position words, a segment
///         that the configuration cannot carry (says which width would do), an auxiliary axis too
///         fast along a spline, nothing moves.
Plan make_plan(const Program& program, const Machine& machine, const PlanOptions& options);

}  // namespace curvecore::ref
