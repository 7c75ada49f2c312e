// SPDX-License-Identifier: Apache-2.0
// Clocks of the cores as functions of their parameters. The latency tests of tb/unit hold the RTL
// to them; planner, choose, run and the benches of tb/hls use them.
//
// No clock depends on the values of words. Segment words are assumed to come without a pause.
#pragma once

#include <algorithm>

#include "ref/format/parameters.hpp"

namespace curvecore {
namespace hls {

using ref::Build;

/// Returns true if a build makes samples, integration steps and segments in turn.
constexpr bool in_turn(Build build) { return build != Build::kParallel; }

/// Parameters of rtl/curve_interpolator.sv, of rtl/curve_interpolator_serial.sv, or of the engine.
struct TimedCore {
    Build build = Build::kParallel;
    int order = 6;
    int coef_bits = 36;
    int aux_axes = 0;
    bool series = true;  // Mode 0
    bool arcs = true;    // Curves
    bool splines = false;
    int sample_interval = 1;  // clocks per sample of the parallel build
    bool anchor = true;       // splines: anchored in every step
    bool networks = true;     // of the parallel build: steps by the networks
};

/// | field   | parallel build                         | serial build and engine, at most   |
/// |---------|----------------------------------------|------------------------------------|
/// | sample  | from a sample to the next              | the same, average of a step; of    |
/// |         |                                        | the engine: without a tick of time |
/// | step    | from an integration step to the next,  | from the last sample of a step to  |
/// |         | while samples before it are drawn      | the first of the next              |
/// | segment | the same, between segments of one step | the same, to the next segment      |
struct Clocks {
    int sample, step, segment;
};

/// Least number of samples that a core makes ahead of the one that is taken, if requests wait: the
/// serial core holds this many, the parallel one more. With auxiliary axes, which a sample's frames
/// send last, it is one less. Of the engine rtl/motion_system.sv asks for 15, the one it takes too.
constexpr int samples_ahead(const TimedCore& core) {
    if (core.build == Build::kEngine) return 14;
    return core.build == Build::kSerial && core.aux_axes > 0 ? 1 : 2;
}

/// Words of a segment on the bus (hls/words.hpp), one a clock, and two clocks to hand them over.
constexpr int load_clocks(const TimedCore& core) { return 19 + 3 * core.aux_axes; }

/// Digits of two bits of a weight: rtl/multiplier/digit_multiplier.sv.
constexpr int weight_digits(const TimedCore& core) { return (core.coef_bits + 1) / 2; }

/// Clocks of a step of rtl/sine_cosine_interpolator.sv, from one start to the next.
constexpr int sine_cosine_step_clocks(const TimedCore& core) {
    return core.order * (weight_digits(core) + 3) + 5;
}

/// Clocks of a step of rtl/hyperbola_interpolator.sv, from start to start; `fresh`: after a load.
constexpr int hyperbola_step_clocks(const TimedCore& core, bool fresh) {
    const int order = core.order;
    const int last_y = 16 + (order - 1) * (weight_digits(core) + 16) + 2 * order * (order + 1);
    const int last_z = last_y + 4 * (order + 1) + 9 - (fresh ? 0 : 13);
    return (core.anchor ? last_y : last_z) + 1;
}

/// Clocks of a step of rtl/network/spherical_steps.sv, from one start to the next.
constexpr int arc_step_clocks(const TimedCore& core) {
    return core.order * (weight_digits(core) + 3) + 7;
}

/// Clocks of rtl/control/spline_sequencer.sv, from start_i to done_o.
constexpr int spline_network_clocks(const TimedCore& core) {
    const int order = core.order;
    const int digits = weight_digits(core);
    const int top = core.anchor ? order - 1 : order;
    const int pause = top >= (core.anchor ? 2 : 3) ? std::max(0, 2 * digits - 31) : 0;
    const int rest_q = order + digits + 6;
    const int rest_series = core.series ? std::max(rest_q, 4 * order + 15) : rest_q;
    const int rest_states = 9 * order + 32 + (order == 2 ? 14 : 0);
    return 9 * top * (top + 1) / 2 + 27 * top + pause + (core.anchor ? rest_series : rest_states) +
           1;
}

/// Clocks of a step of rtl/network/spline_steps.sv, from start_i to done_o; `fresh`: the segment's
/// first.
constexpr int spline_step_clocks(const TimedCore& core, bool fresh) {
    return (core.anchor || fresh ? 92 : 3) + spline_network_clocks(core);
}

constexpr int kNextSplineStep = 2;  // from done_o to the next start_i

/// Clocks of rtl/arithmetic/horner.sv.
constexpr int horner_clocks(const TimedCore& core, int passes) {
    return core.sample_interval == 1 ? passes * 6 + 1
                                     : passes * (core.sample_interval == 2 ? 7 : 9);
}

/// Clocks from tau to a displacement: rtl/sampler/curve_sampler.sv.
constexpr int sampler_clocks(const TimedCore& core) {
    if (core.series) return horner_clocks(core, core.order);
    if (!core.splines) {
        return horner_clocks(core, core.order / 2) + (core.sample_interval == 2 ? 19 : 18);
    }
    return horner_clocks(core, core.order) + horner_clocks(core, 3) + (core.arcs ? 1 : 0);
}

/// Clocks of the parallel build from a request to its sample; up to sample_interval - 1 more. Where
/// there are the clocks for it, one lander does all axes (rtl/sampler/sample_landing.sv).
constexpr int sample_latency(const TimedCore& core) {
    const int axes = 3 + core.aux_axes;
    return 12 + 3 * core.sample_interval + sampler_clocks(core) +
           (axes <= core.sample_interval ? axes : 0);
}

/// Rotation of the serial build, in which everything runs (rtl/serial/serial_sequencer.sv). A
/// sample takes one rotation for every frame of its program.
constexpr int kRotation = 9;
constexpr int aux_frames(const TimedCore& core) { return (core.aux_axes + 2) / 3; }
constexpr int sample_frames(const TimedCore& core, bool spline) {
    return (core.series ? core.order
            : spline    ? core.order + 3
                        : 4 + core.order / 2) +
           aux_frames(core);
}

/// Clocks of a sample; three at a time share the multiplier, and request to tau is the minimum.
constexpr int serial_sample_clocks(const TimedCore& core, bool spline) {
    return std::max(aux_frames(core) < 2 ? 21 : 27, 3 * (sample_frames(core, spline) + 1));
}

/// Upper bound of a delay: auxiliary axes' samples go out while the next one's points are read.
constexpr int late_clocks(const TimedCore& core) { return std::min(core.aux_axes, 4); }

/// Clocks of arcs; steps reach them in every configuration, except for late_clocks; a segment's
/// words end within a rotation, so its bound is up to two of them above the clocks.
constexpr Clocks serial_arc_clocks(const TimedCore& core) {
    const int order = core.order;
    const int sample = kRotation * sample_frames(core, false);
    const int aux_words = (3 * core.aux_axes + 7) / kRotation;
    const int angle = core.series ? 0 : 9 * order + 36;
    return {serial_sample_clocks(core, false),
            kRotation * ((5 * order + 1) / 3) + sample + 75 + late_clocks(core),
            27 * order + sample + kRotation * aux_words + 57 + angle + late_clocks(core)};
}

constexpr Clocks serial_spline_clocks(const TimedCore& core) {
    const int order = core.order;
    const int sample = kRotation * sample_frames(core, true);
    const int network = 4 * order * order + 37 * order +
                        (core.series ? 3 * order * (order + 11) / 2 - 9 : 0) +
                        (core.series && order == 2 ? 11 : 0);  // its short sums wait for each other
    return {serial_sample_clocks(core, true),
            network + 2 * order + sample + 120 + late_clocks(core),
            network + sample + 3 * core.aux_axes + 162 + late_clocks(core)};
}

/// The engine does one thing after the other, samples that are asked for before the host's words.
/// In W = 1 + samples_ahead() periods it makes W samples, their ticks and what changes in them: if
/// that fits there, as the planner has it, no sample is late. For let sample m be asked for, W
/// periods before it is due, while it has none to make. The n samples from then on are n / W of
/// these windows, rounded up, and so ready within n + W - 1 periods, in time; the word that it was
/// at takes less than what that leaves. So no host makes a sample late: words have the rest of the
/// clocks, and if they come too slowly, a hold (rtl/engine/programs/ledger.asm). The clocks of a
/// segment have its words.
///
/// Programs of the engine, at most: tb/model/hls/engine_clocks_test.cpp holds these to what the
/// assembler says of rtl/engine/programs and ref/curves.
constexpr int kEngineFollowClocks = 60;  // of a sample, besides its curve
constexpr int kEngineRestClocks = 214;   // the loop: a request and the sample
constexpr int kEngineTickClocks = 2059;  // of time, with a piece that begins

/// Steps of a stop branch that the engine loads in a tick, while it has no piece to fetch.
constexpr int kEngineBranchSteps = 2;

/// Rates of the axes in place of positions, on top: of boards (rtl/engine/programs/places.asm).
constexpr int engine_place_clocks(const TimedCore& core) { return 330 + 112 * core.aux_axes; }

/// Clocks in which a word enters its queue, on the average of a segment's: a few take three times
/// as long. And the words that enter for a segment: its own, and those of two pieces with a step
/// each of a branch.
constexpr int kEngineEntryClocks = 160;
constexpr int engine_entry_words(const TimedCore& core) { return load_clocks(core) + 12; }

/// Clocks of the auxiliary axes: those of each, and of going to them.
constexpr int engine_aux_clocks(const TimedCore& core, int each) {
    return core.aux_axes == 0 ? 0 : each * core.aux_axes + 2;
}

constexpr int engine_curve_clocks(const TimedCore& core, bool spline) {
    const int order = core.order;
    return (core.series ? 48 * order + 159
            : spline    ? 33 * order + 322
                        : 16 * order + 424) +
           engine_aux_clocks(core, 37);
}

constexpr int engine_step_clocks(const TimedCore& core, bool spline) {
    const int order = core.order;
    const int step = !spline       ? 184 * order + 340
                     : core.series ? (120 * order + 199) * order + 780
                                   : (91 * order + 94) * order + 960;
    return step + engine_aux_clocks(core, 31);
}

/// Clocks of a segment's words, besides its curve: to enter, and of auxiliary axes to be fetched.
constexpr int engine_entry_clocks(const TimedCore& core) {
    return engine_aux_clocks(core, 72) + kEngineEntryClocks * engine_entry_words(core);
}

constexpr int engine_segment_clocks(const TimedCore& core, bool spline) {
    const int load = spline ? 1000 + engine_step_clocks(core, spline) : 144 * core.order + 990;
    return load + engine_entry_clocks(core);
}

/// Clocks of a sample whose curve takes so many of them.
constexpr int engine_sample_clocks(const TimedCore& core, int of_curve) {
    return kEngineRestClocks + kEngineFollowClocks + of_curve + engine_place_clocks(core);
}

constexpr Clocks engine_clocks(const TimedCore& core, bool spline) {
    const int sample = engine_sample_clocks(core, engine_curve_clocks(core, spline));
    return {sample, sample + engine_step_clocks(core, spline),
            sample + engine_segment_clocks(core, spline)};
}

/// Clocks from a tick of time to the next; the engine makes ticks and samples in turn. The serial
/// build, a curve core alone, makes none.
constexpr int tick_clocks(const TimedCore& core) {
    return core.build == Build::kEngine ? kEngineTickClocks : core.sample_interval;
}

/// Clocks of a part of the program, words and two more, and of the rest of a step, which sends its
/// points: rtl/serial/folded_steps.sv.
constexpr int part_clocks(int words) { return words + 2; }
constexpr int send_clocks(const TimedCore& core) { return 3 * (3 + core.aux_axes) + 2; }

/// Clocks of steps along lines and arcs by the program.
constexpr Clocks folded_arc_clocks(const TimedCore& core) {
    const int order = core.order;
    const int rest = (core.series ? 0 : part_clocks(11 * order + 18)) +
                     part_clocks(15 * order + 14) + send_clocks(core);
    return {core.sample_interval, 1 + part_clocks(18) + rest,
            load_clocks(core) - 1 + part_clocks(11 * (order - 1)) + rest};
}

/// Clocks of steps along splines by the program: sums of more than eight products take longer than
/// the wait for a result does.
constexpr Clocks folded_spline_clocks(const TimedCore& core) {
    const int order = core.order;
    const int late = std::max(0, order - 8);
    const int network = 4 * order * order + 37 * order + late * (late - 1) / 2 +
                        (core.series ? 3 * order * (order + 11) / 2 - order + 2 : 0) +
                        send_clocks(core);
    const int keep = core.series ? 0 : part_clocks(3);
    return {core.sample_interval, network + order + late + keep + 84,
            load_clocks(core) - 1 + network + 98};
}

/// Clocks along lines, arcs and helices.
constexpr Clocks arc_clocks(const TimedCore& core) {
    if (core.build == Build::kEngine) return engine_clocks(core, false);
    if (core.build == Build::kSerial) return serial_arc_clocks(core);
    if (!core.networks) return folded_arc_clocks(core);
    const int step = arc_step_clocks(core);
    return {core.sample_interval, step, std::max(step, load_clocks(core))};
}

/// Clocks along splines.
constexpr Clocks spline_clocks(const TimedCore& core) {
    if (core.build == Build::kEngine) return engine_clocks(core, true);
    if (core.build == Build::kSerial) return serial_spline_clocks(core);
    if (!core.networks) return folded_spline_clocks(core);
    return {core.sample_interval, spline_step_clocks(core, false) + kNextSplineStep,
            std::max(spline_step_clocks(core, true) + kNextSplineStep, load_clocks(core))};
}

}  // namespace hls
}  // namespace curvecore
