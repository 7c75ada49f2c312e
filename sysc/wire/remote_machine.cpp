// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/remote_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hls/registers/registers.h"
#include "hls/words.hpp"
#include "ref/curve/axes.hpp"
#include "sysc/board/faults.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/wire/shaper_words.hpp"

namespace curvecore::sysc {
namespace {

constexpr auto kSettles = std::chrono::seconds(10);  // as a board that is silent has

/// Bytes on a line for a full frame: CRC, end, and one in 64 escaped.
constexpr double kLineBytes = (CURVECORE_LONGEST_FRAME + 4 + 1) * (1 + 1.0 / 64);

RemoteBuild build_of(const curvecore_board& board) {
    const std::uint32_t version = board.version;
    if (curvecore_knows(version) == 0) {
        throw UsageError(
            fmt::format("the board has registers of version {}; this program knows version {}",
                        CURVECORE_FIELD(version, VERSION_MAP), CURVECORE_VERSION_MAP_VALUE));
    }
    const std::uint32_t capability = board.capability;
    const std::uint32_t core = board.core;
    const std::uint32_t words = CURVECORE_FIELD(version, VERSION_WORDS);
    if (words != hls::kWordsVersion) {
        throw UsageError(fmt::format("the board takes words of version {}; these are of version {}",
                                     words, hls::kWordsVersion));
    }
    RemoteBuild build;
    build.axes = static_cast<int>(CURVECORE_FIELD(capability, CAPABILITY_AXES));
    build.clock_hz = board.hertz;
    build.sample_period_s =
        std::exp2(CURVECORE_FIELD(capability, CAPABILITY_PERIOD_LOG2)) / build.clock_hz;
    build.segment_queue_words = 1 << CURVECORE_FIELD(capability, CAPABILITY_SEGMENT_QUEUE_LOG2);
    build.profile_queue_words = 1 << CURVECORE_FIELD(capability, CAPABILITY_PROFILE_QUEUE_LOG2);
    build.widths = board.widths;
    build.encoders = CURVECORE_FIELD(capability, CAPABILITY_ENCODERS) != 0;
    const std::uint32_t outputs = CURVECORE_FIELD(capability, CAPABILITY_OUTPUTS_LOG2);
    build.outputs = outputs == 0 ? 0 : 1 << outputs;
    const std::uint32_t places = CURVECORE_FIELD(board.widths, WIDTHS_SHAPER_LOG2);
    build.shaper_places = places == 0 ? 0 : 1 << places;
    if (CURVECORE_FIELD(capability, CAPABILITY_BUILD) != 0) {
        throw UsageError(
            "the board has the serial build, which moves nothing any more: make it again with "
            "Build 2, or use a program of its time");
    }
    build.core.build =
        CURVECORE_FIELD(capability, CAPABILITY_ENGINE) != 0 ? Build::kEngine : Build::kParallel;
    build.core.splines = static_cast<int>(CURVECORE_FIELD(capability, CAPABILITY_SPLINES));
    build.core.aux_axes = build.axes - 3;
    build.core.order = static_cast<int>(CURVECORE_FIELD(core, CORE_ORDER));
    build.core.mode = static_cast<int>(CURVECORE_FIELD(core, CORE_MODE));
    build.core.coef_bits = static_cast<int>(CURVECORE_FIELD(core, CORE_COEF_BITS));
    build.core.position_bits = static_cast<int>(CURVECORE_FIELD(core, CORE_POSITION_BITS));
    build.core.guard_bits = static_cast<int>(CURVECORE_FIELD(core, CORE_GUARD_BITS));
    build.table = CURVECORE_FIELD(core, CORE_TABLE);
    return build;
}

}  // namespace

std::string fault_names(std::uint32_t state) {
    const std::uint32_t of_axis =
        state & (CURVECORE_STATE_ENCODER_MASK | CURVECORE_STATE_FOLLOWING_MASK);
    std::string text = fault_list(state & ~of_axis, "; ");
    if (of_axis != 0) {
        const char axis = ref::kAxisLetters[CURVECORE_FIELD(state, STATE_FAULT_AXIS)];
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", axis, fault_list(of_axis, "; "));
    }
    return text;
}

RemoteMachine::RemoteMachine(Link& link, std::uint32_t session)
    : link_(link), frames_(link), build_(build_of(frames_.board())) {
    frames_.open(session);
}

RemoteBuild ask_build(Link& link) { return build_of(FrameStream(link).board()); }

void RemoteMachine::write(std::uint32_t address, std::uint32_t word) {
    while (!frames_.may_send()) frames_.work();
    curvecore_write(frames_.begin(), address, word);
    frames_.send();
}

/// Reads a register after all that was written.
std::uint32_t RemoteMachine::read(std::uint32_t address) {
    frames_.finish();
    return frames_.read(address);
}

void RemoteMachine::control(std::uint32_t bits) {
    control_ = bits;
    write(CURVECORE_CONTROL, bits);
}

/// Waits until motion has stopped so far that STATE has this bit.
void RemoteMachine::settle(std::uint32_t mask) {
    const WireClock::time_point settled = now() + kSettles;
    do {
        frames_.finish();
        frames_.work();
        if (now() > settled) throw UsageError("the board does not stop what it draws");
    } while (!is(mask));
}

std::uint64_t RemoteMachine::stand() {
    control_ = read(CURVECORE_CONTROL);
    const std::uint32_t state = read(CURVECORE_STATE);
    const std::uint64_t path = read(CURVECORE_PATH_LO) | std::uint64_t{read(CURVECORE_PATH_HI)}
                                                             << 32;
    // At a wait for a person nothing is active.
    const bool begun = (state & CURVECORE_STATE_ACTIVE_MASK) != 0 || path > 0;
    if ((state & CURVECORE_STATE_ENABLED_MASK) == 0 || !begun) {
        throw UsageError("the board has no program under way that it could go on with");
    }
    hold(true);
    settle(CURVECORE_STATE_STANDING_MASK);
    return telemetry().path;
}

void RemoteMachine::prepare(const Drives& drives, double unit_mm) {
    // Another host may have left any state.
    control(0);
    settle(CURVECORE_STATE_CLEAN_MASK);
    write(CURVECORE_STATE, CURVECORE_FAULTS);

    const auto range = std::exp2(build_.core.position_bits) * unit_mm;  // mm
    for (int axis = 0; axis < build_.axes; ++axis) {
        const double scale = std::round(drives.steps_per_mm[axis] * range * std::exp2(16));
        if (scale >= static_cast<double>(curvecore_scale_end(build_.widths))) {
            throw UsageError(fmt::format(
                "{:g} steps per mm are too many for the board, whose scales "
                "have {} bits",
                drives.steps_per_mm[axis], CURVECORE_FIELD(build_.widths, WIDTHS_SCALE_BITS)));
        }
        set_scale(axis, static_cast<std::uint64_t>(scale));
    }
    const std::uint32_t most = curvecore_most_clocks(build_.widths);
    const auto clocks = [this, most](const char* what, double time_s) {
        const double count = std::ceil(time_s * build_.clock_hz - 1e-6);
        if (count > most) {
            throw UsageError(fmt::format("--{} of {:g} us is more than {} clocks of the board",
                                         what, time_s * 1e6, most));
        }
        return static_cast<std::uint32_t>(count);
    };
    write(CURVECORE_PULSE,
          clocks("steplen", drives.steplen_s) | clocks("stepspace", drives.stepspace_s) << 16);
    shape(drives);
    write(CURVECORE_DIRECTION,
          clocks("dirsetup", drives.dirsetup_s) | clocks("dirhold", drives.dirhold_s) << 16);
    ignore_limits(0);
}

/// Sets the shaper, which keeps the words of another host.
void RemoteMachine::shape(const Drives& drives) {
    shaper_samples_ = 0;
    if (build_.shaper_places == 0) return;
    for (const std::uint32_t word : shaper_words(drives.shaper, build_.axes, drives.tool_delay)) {
        write(CURVECORE_SHAPER, word);
    }
    for (int axis = 0; axis < build_.axes; ++axis) {
        const ref::ShaperTaps& taps = drives.shaper[static_cast<std::size_t>(axis)];
        shaper_samples_ = std::max(shaper_samples_, 2 * taps.delay);
    }
}

/// Sets a scale; counts of steps give an axis' place as long as its scale is unchanged.
void RemoteMachine::set_scale(int axis, std::uint64_t scale) {
    const std::uint32_t at = static_cast<std::uint32_t>(axis) * CURVECORE_AXIS_STRIDE;
    const std::uint64_t low = read(CURVECORE_AXIS_SCALE_LO + at);
    if (scale == (low | std::uint64_t{read(CURVECORE_AXIS_SCALE_HI + at)} << 32)) return;
    write(CURVECORE_AXIS_SCALE_LO + at, static_cast<std::uint32_t>(scale));
    write(CURVECORE_AXIS_SCALE_HI + at, static_cast<std::uint32_t>(scale >> 32));
    forget_place(axis);
}

void RemoteMachine::begin(const BoardSettings& settings, int watchdog_samples) {
    write(CURVECORE_PROBE, 0);
    write(CURVECORE_OVERRIDE, static_cast<std::uint32_t>(settings.override_word));
    write(CURVECORE_WATCHDOG, static_cast<std::uint32_t>(watchdog_samples));
    if (watchdog_samples > 0) {
        const double silence = watchdog_samples * build_.sample_period_s;
        frames_.live_each(std::chrono::duration_cast<WireClock::duration>(
            std::chrono::duration<double>(silence / CURVECORE_SIGNS_OF_LIFE)));
    }
    set(settings);
    write(CURVECORE_REFERENCE, (1U << build_.axes) - 1);
    control(CURVECORE_CONTROL_ENABLE_MASK);
    frames_.finish();
    if (!is(CURVECORE_STATE_ENABLED_MASK)) {
        throw UsageError("the machine does not come on: " + fault_names(why_off()));
    }
}

void RemoteMachine::begin_here(const BoardSettings& settings) {
    set(settings);
    control(CURVECORE_CONTROL_ENABLE_MASK);
    frames_.finish();
}

void RemoteMachine::set(const BoardSettings& settings) {
    write(CURVECORE_TIMING, static_cast<std::uint32_t>(settings.samples_per_tick_log2));
    write(CURVECORE_HOLD_ACCELERATION, settings.hold_acceleration);
    write(CURVECORE_HOLD_SLOPE, static_cast<std::uint32_t>(settings.hold_slope));
    write(CURVECORE_STOP_TICKS, settings.stop_ticks);
    write(CURVECORE_DIGEST, settings.host_digest);
}

/// Faults, and pins that count as none while the machine is off.
std::uint32_t RemoteMachine::why_off() const {
    const Telemetry& now = telemetry();
    std::uint32_t why = now.state;
    if (is(CURVECORE_STATE_ESTOP_PIN_MASK)) why |= CURVECORE_STATE_ESTOP_INPUT_MASK;
    if ((now.axes & CURVECORE_AXES_LIMIT_MASK) != 0) why |= CURVECORE_STATE_LIMIT_MASK;
    return why == now.state ? why : why & ~CURVECORE_STATE_BUS_MASK;
}

RemoteMachine::WordCounts RemoteMachine::push(std::deque<std::uint64_t>& segments,
                                              std::deque<std::uint64_t>& pieces,
                                              const WordCounts& most) {
    if (!frames_.may_send()) return {};
    const auto fits = [](std::uint64_t words, int room) {
        return std::min<std::size_t>(words, std::max(room, 0));
    };
    const std::size_t segment_words = fits(most.segments, telemetry().segment_room);
    const std::size_t profile_words = fits(most.pieces, telemetry().profile_room);
    const std::size_t longest = frames_.words_of_frame();
    const std::size_t count = std::min(segment_words + profile_words, longest);
    // Short frames wait for words before: fewer are under way, and fewer are repeated.
    if (count == 0 || (count < longest && frames_.words_under_way())) return {};
    // Half of each, where there are enough.
    const std::size_t rest = count - std::min(count, profile_words);
    const std::size_t of_segments = std::min(segment_words, std::max(count / 2, rest));
    curvecore_frame* frame = frames_.begin();
    const auto fill = [frame](std::uint32_t address, std::deque<std::uint64_t>& words,
                              std::size_t number) {
        if (number == 0) return;
        const auto end = words.begin() + static_cast<std::ptrdiff_t>(number);
        const std::vector<std::uint64_t> pushed(words.begin(), end);
        curvecore_push(frame, address, pushed.data(), static_cast<int>(number));
        words.erase(words.begin(), end);
    };
    fill(CURVECORE_SEGMENT_LO, segments, of_segments);
    fill(CURVECORE_PROFILE_LO, pieces, count - of_segments);
    frames_.send(static_cast<int>(of_segments), static_cast<int>(count - of_segments));
    return {of_segments, count - of_segments};
}

double RemoteMachine::words_per_s() const {
    return link_.bytes_per_s() / kLineBytes * static_cast<double>(frames_.words_of_frame());
}

void RemoteMachine::set_override(int word) {
    write(CURVECORE_OVERRIDE, static_cast<std::uint32_t>(word));
}

void RemoteMachine::hold(bool on) {
    constexpr std::uint32_t kHold = CURVECORE_CONTROL_HOLD_MASK;
    control(on ? control_ | kHold : control_ & ~kHold);
}

void RemoteMachine::estop() { control(CURVECORE_CONTROL_ESTOP_MASK); }

void RemoteMachine::clear_watchdog() { write(CURVECORE_STATE, CURVECORE_STATE_WATCHDOG_MASK); }

void RemoteMachine::flush(bool keep_outputs) {
    const std::uint32_t keep = keep_outputs ? CURVECORE_CONTROL_KEEP_MASK : 0;
    control(control_ | keep | CURVECORE_CONTROL_FLUSH_MASK);
}

void RemoteMachine::disable() { control(0); }

std::vector<std::int32_t> RemoteMachine::steps() {
    std::vector<std::int32_t> counts;
    for (int axis = 0; axis < build_.axes; ++axis) {
        const std::uint32_t at = static_cast<std::uint32_t>(axis) * CURVECORE_AXIS_STRIDE;
        counts.push_back(static_cast<std::int32_t>(frames_.read(CURVECORE_AXIS_STEPS + at)));
    }
    return counts;
}

std::uint32_t RemoteMachine::outputs() { return frames_.read(CURVECORE_OUTPUTS); }

void RemoteMachine::wait_for_switch(int axis, bool closed) {
    write(CURVECORE_PROBE, static_cast<std::uint32_t>(axis) |
                               (closed ? CURVECORE_PROBE_HIGH_MASK : 0) |
                               CURVECORE_PROBE_ARMED_MASK);
}

bool RemoteMachine::switch_closed(int axis) {
    return (CURVECORE_FIELD(read(CURVECORE_SWITCHES), SWITCHES_HOME) >> axis & 1) != 0;
}

std::int32_t RemoteMachine::caught_steps(int axis) {
    const std::uint32_t at = static_cast<std::uint32_t>(axis) * CURVECORE_AXIS_STRIDE;
    return static_cast<std::int32_t>(read(CURVECORE_AXIS_CAUGHT + at));
}

void RemoteMachine::ignore_limits(std::uint32_t axes) {
    const std::uint32_t others = read(CURVECORE_PINS) & ~CURVECORE_PINS_LIMIT_MASKED_MASK;
    write(CURVECORE_PINS, others | CURVECORE_PUT(PINS_LIMIT_MASKED, axes));
}

std::uint32_t RemoteMachine::homed() {
    return CURVECORE_FIELD(read(CURVECORE_SWITCHES), SWITCHES_HOMED);
}

void RemoteMachine::forget_place(int axis) { write(CURVECORE_HOMED, homed() & ~(1U << axis)); }

void RemoteMachine::keep_origin(int axis, std::int32_t origin) {
    write(CURVECORE_ORIGIN0 + 4 * static_cast<std::uint32_t>(axis),
          static_cast<std::uint32_t>(origin));
}

void RemoteMachine::set_origin(int axis, std::int32_t origin) {
    keep_origin(axis, origin);
    write(CURVECORE_HOMED, homed() | 1U << axis);
}

void RemoteMachine::watch(int axis, EncoderRatio encoder, std::uint32_t limit) {
    const auto at = static_cast<std::uint32_t>(4 * axis);
    write(CURVECORE_ENCODER_RATIO0 + at, (static_cast<std::uint32_t>(encoder.counts) & 0xffff) |
                                             static_cast<std::uint32_t>(encoder.steps) << 16);
    write(CURVECORE_FOLLOWING_LIMIT0 + at, limit);
}

std::pair<std::int32_t, std::int32_t> RemoteMachine::following(int axis) {
    const auto at = static_cast<std::uint32_t>(4 * axis);
    return {static_cast<std::int32_t>(read(CURVECORE_FOLLOWING0 + at)),
            static_cast<std::int32_t>(read(CURVECORE_FOLLOWING_WORST0 + at))};
}

std::vector<std::optional<std::int32_t>> RemoteMachine::places() {
    const std::uint32_t homed_axes = homed();
    const std::vector<std::int32_t> kept = kept_places();
    std::vector<std::optional<std::int32_t>> all(kept.size());
    for (std::size_t axis = 0; axis < all.size(); ++axis) {
        if ((homed_axes >> axis & 1) != 0) all[axis] = kept[axis];
    }
    return all;
}

void RemoteMachine::keep_places(const std::vector<std::int32_t>& now) {
    const std::uint32_t homed_axes = homed();
    const std::vector<std::int32_t> counts = steps();
    for (std::size_t axis = 0; axis < now.size(); ++axis) {
        if ((homed_axes >> axis & 1) != 0) continue;
        keep_origin(static_cast<int>(axis), counts[axis] - now[axis]);
    }
}

std::vector<std::int32_t> RemoteMachine::kept_places() {
    std::vector<std::int32_t> all = steps();
    for (std::size_t axis = 0; axis < all.size(); ++axis) {
        const auto at = static_cast<std::uint32_t>(CURVECORE_ORIGIN0 + 4 * axis);
        all[axis] -= static_cast<std::int32_t>(read(at));
    }
    return all;
}

}  // namespace curvecore::sysc
