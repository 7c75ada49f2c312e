// SPDX-License-Identifier: Apache-2.0
// Options of a plan: the core, its time and queues, and the way in which the feed is planned.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>

#include "ref/format/parameters.hpp"
#include "ref/format/queues.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/plan/segment.hpp"

namespace curvecore::ref {

class KnownCuts;  // ref/segment/spline_cut.hpp
class Workers;    // ref/numeric/workers.hpp

/// Time of a core for the start of a step within its segment, and of a segment, s.
struct CurveTime {
    double step = 0;
    double segment = 0;
};

/// | field         | unit | remark                                                              |
/// |---------------|------|---------------------------------------------------------------------|
/// | curve         | s    | by kind, beyond the time of a sample                                |
/// | ahead         |      | true: during the samples of the last step; false: in turn           |
/// | sample        | s    | time of a sample in which the core makes no steps; 0 with ahead     |
/// | samples_ahead | 1    | samples that the core makes ahead of the one that is due            |
/// | branch_steps  | 1    | steps of a stop branch that the core loads in a tick; 0: any number |
struct CoreTime {
    ByKind<CurveTime> curve{{{{2e-6, 2e-6}, {4e-6, 4e-6}, {4e-6, 4e-6}}}};
    bool ahead = true;
    double sample = 0;
    int samples_ahead = 2;
    int branch_steps = 0;
};

/// Method of planning the feed: by rules, one bound for each move and ramps between; or as the
/// fastest motion under the same limits on the true path (ref/feed/optimum/time_optimum.hpp).
enum class Effort { kRules, kOptimum };
constexpr std::array<std::string_view, 2> kEffortNames = {"rules", "optimum"};

/// Method of stopping from the rate 1: on a branch planned for the place, which costs the host
/// words; or by the bounds of the whole program.
enum class Holds { kBranches, kBounds };
constexpr std::array<std::string_view, 2> kHoldNames = {"branches", "bounds"};

/// | field                  | unit   | remark                                                     |
/// |------------------------|--------|------------------------------------------------------------|
/// | unit_mm                | mm     | the length unit                                            |
/// | sample_period_s        | s      |                                                            |
/// | samples_per_tick       | 1      | 2^n; a tick is the profile's clock                         |
/// | format                 |        | word widths and order of the core                          |
/// | aux_axes               | 1      | auxiliary axes of the core; more in a program are refused  |
/// | error_limit            | units  | every segment's derived bound stays below it               |
/// | core                   |        | times of the core: feed/places/step_speed.hpp              |
/// | segment_queue_words    | 1      | queues of the core: their words outlast a stop             |
/// | profile_queue_words    | 1      |                                                            |
/// | max_pieces             | 1      | segments of one move; one that needs more is refused       |
/// | effort                 |        | method of planning the feed                                |
/// | holds                  |        | by stop branches, with an optimum; or by bounds alone      |
/// | window                 | 1      | moves that are planned at once, 2 at least                 |
/// | horizon_s              | s      | motion that an optimum plans at once, or twice the time of |
/// |                        |        | a stop if that is longer; unlimited: what `window` says    |
/// | advise                 |        | a refusal names a width that suffices: takes many plans    |
/// | cuts                   |        | of cubics that were cut before; none: they are not kept    |
/// | workers                |        | threads that plan besides; none: this one alone            |
struct PlanOptions {
    double unit_mm = 1e-6;
    double sample_period_s = 100e-6;
    int samples_per_tick = 1;
    CoreParameters format;
    int aux_axes = kAuxAxes;
    double error_limit = 0.1;
    CoreTime core;
    int segment_queue_words = kSegmentQueueWords;
    int profile_queue_words = kProfileQueueWords;
    int max_pieces = 1 << 16;
    bool advise = true;
    Effort effort = Effort::kOptimum;
    Holds holds = Holds::kBranches;
    std::size_t window = 3000;
    double horizon_s = kUnlimited;
    std::shared_ptr<KnownCuts> cuts;
    std::shared_ptr<Workers> workers;

    bool has_branches() const { return effort == Effort::kOptimum && holds == Holds::kBranches; }
    double tick_s() const { return sample_period_s * samples_per_tick; }
};

}  // namespace curvecore::ref
