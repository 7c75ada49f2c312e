// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "ref/format/queues.hpp"
#include "ref/program/program_reader.hpp"
#include "sysc/cli/choice.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/core/board_file.hpp"
#include "sysc/core/core_clocks.hpp"
#include "sysc/core/core_file.hpp"
#include "sysc/job/linuxcnc_program.hpp"

namespace curvecore::sysc {
namespace {

std::uint64_t whole(const std::string& option, const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) {
        throw UsageError(fmt::format("{} '{}': not a whole number", option, text));
    }
    return value;
}

int power_of_two(const std::string& option, const std::string& text, int low, int high) {
    const std::uint64_t number = whole(option, text);
    const bool inside = number >= std::uint64_t(low) && number <= std::uint64_t(high);
    if (!inside || (number & (number - 1)) != 0) {
        throw UsageError(fmt::format("{} must be a power of two in [{}, {}]", option, low, high));
    }
    return static_cast<int>(number);
}

/// Checks that the core is built, with or without splines while that is open.
void check_built(const Options& options) {
    CoreParameters core = options.core;
    const std::string reason = ref::why_not_built(core);
    if (!options.splines_set) core.splines = 1;
    if (!ref::legal(core) && !reason.empty()) throw UsageError(reason);
}

void set_clock(double hz, Options& options) {
    options.clock_hz = hz;
    options.clock_set = true;
}

/// Sets the system's blocks; that of the interpolator is the board's.
void set_system(const std::vector<std::string>& given, Options& options) {
    if (!given.empty() && !options.in_system()) {
        throw UsageError("--system is for --on systemc and systemc-rtl");
    }
    if (options.needs_rtl()) options.system.interpolator = BlockKind::kRtl;
    for (const std::string& text : given) set_system(options.system, text);
    if (options.in_system()) {
        options.board = options.system.interpolator == BlockKind::kRtl ? BoardKind::kSystemcRtl
                                                                       : BoardKind::kSystemc;
    }
}

ref::PointsOptions points_options(const RawOptions& raw, const std::string& file) {
    ref::PointsOptions points;
    points.fit = static_cast<ref::Fit>(choice("--fit", raw.fit, ref::kFitNames));
    points.ends = static_cast<ref::Ends>(choice("--ends", raw.ends, ref::kEndsNames));
    points.parametrisation = static_cast<ref::Parametrisation>(
        choice("--parametrisation", raw.parametrisation, ref::kParametrisationNames));
    points.feed = speed("--feed", raw.feed);
    const RawOptions unset;
    if (raw.ends != unset.ends && points.fit != ref::Fit::kC2) {
        throw UsageError("--ends is for --fit c2");
    }
    const bool fit = raw.fit != unset.fit && points.fit != ref::Fit::kArcs;
    const bool asked =
        fit || raw.parametrisation != unset.parametrisation || raw.feed != unset.feed;
    if (asked && !ref::is_points_file(file)) {
        throw UsageError("--fit but for arcs, --parametrisation and --feed are for points (.csv)");
    }
    return points;
}

constexpr double kArcTolerance = 1e-3;  // mm
constexpr std::array<std::string_view, 2> kPathNames{"program", "exact"};
constexpr std::array<std::string_view, 2> kInterpreterNames{"curvecore", "linuxcnc"};

/// Tolerance of --fit arcs, mm.
std::optional<double> arc_tolerance(const RawOptions& raw, ref::Fit fit) {
    if (fit != ref::Fit::kArcs) {
        if (!raw.tolerance.empty()) throw UsageError("--tolerance is for --fit arcs");
        return std::nullopt;
    }
    return raw.tolerance.empty() ? kArcTolerance : length("--tolerance", raw.tolerance, 1e-6, 10);
}

/// Interpreter of the program, unless it is this program's own reader.
ref::OpenProgram open_program(const RawOptions& raw, const Options& options) {
    if (choice("--interpreter", raw.interpreter, kInterpreterNames) == 0) return {};
    if (ref::is_points_file(options.file) || options.file == ref::kStandardInput) {
        throw UsageError("--interpreter linuxcnc is for files of G-code");
    }
    return [ini = options.machine, tools = raw.tools,
            within = options.points.fit_tolerance](const std::string& file) {
        return open_linuxcnc(file, {ini, tools}, within);
    };
}

/// Sets the state that a program begins with; LinuxCNC's interpreter reads it from its own files.
void set_start(const RawOptions& raw, Options& options) {
    const bool points = ref::is_points_file(options.file);
    const bool tolerance = !raw.radii_tolerance.empty();
    if (points && (!raw.tools.empty() || tolerance)) {
        throw UsageError("--tools and --arc-tolerance are for G-code");
    }
    if (options.open_program && tolerance) {
        throw UsageError("--arc-tolerance or --interpreter: LinuxCNC has its own tolerance");
    }
    if (points || options.open_program || options.file.empty()) return;
    ref::ProgramStart& start = options.gcode.start;
    start = ref::read_program_start(options.machine, raw.tools);
    if (tolerance) {
        start.arc_tolerance = length("--arc-tolerance", raw.radii_tolerance, 1e-6, 1000);
    }
}

}  // namespace

double unit_of(const std::string& text) { return length("--unit", text, 1e-7, 1); }

double bound_limit(const std::string& text, double standard, double unit_mm,
                   const CoreParameters& core) {
    const double error = text.empty() ? standard : length("--error", text, 1e-7, 1e3);
    // so that 0.6 - 0.5 is 0.1
    const double limit = std::round((error / unit_mm - core.rounding()) * 1e9) / 1e9;
    if (!(limit >= 0.001 && limit <= 1e6)) {
        throw UsageError(fmt::format(
            "--error {}: must be in [0.501, 1000000] units of {}; half a unit is lost by rounding",
            exact_length(error), exact_length(unit_mm)));
    }
    return limit;
}

Build build_of(const std::string& text) {
    const bool serial = same_name(text, "serial");
    if (!serial && !same_name(text, "parallel")) {
        throw UsageError(fmt::format("--build '{}': must be parallel or serial", text));
    }
    return serial ? Build::kSerial : Build::kParallel;
}

int Options::samples_per_tick_log2() const {
    int n = 0;
    while ((1 << n) < samples_per_tick) ++n;
    return n;
}

std::int32_t Options::override_word() const {
    return static_cast<std::int32_t>(std::lround(std::min(1.0, override_percent / 100) * 65536));
}

double Options::feed_factor() const { return std::max(1.0, override_percent / 100); }

ref::PlanOptions Options::plan_options() const {
    ref::PlanOptions plan;
    plan.unit_mm = unit_mm;
    plan.sample_period_s = sample_period_s;
    plan.samples_per_tick = samples_per_tick;
    plan.format = core;
    plan.aux_axes = core.aux_axes;
    plan.error_limit = error_limit;
    plan.core = core_time(core, clock_hz);
    plan.effort = effort;
    plan.holds = holds;
    plan.segment_queue_words = segment_queue_words;
    plan.profile_queue_words = profile_queue_words;
    return plan;
}

void interpret(const RawOptions& raw, Options& options) {
    if (options.folder.empty()) {
        options.folder = (options.file == ref::kStandardInput ? "stdin" : options.file) + ".out";
    }
    options.points = points_options(raw, options.file);
    options.effort = static_cast<ref::Effort>(choice("--effort", raw.effort, ref::kEffortNames));
    options.holds = static_cast<ref::Holds>(choice("--holds", raw.holds, ref::kHoldNames));
    options.exact_path = choice("--path", raw.path, kPathNames) == 1;
    options.open_program = open_program(raw, options);
    set_start(raw, options);
    if (!raw.dialect.empty()) {
        if (options.open_program)
            throw UsageError("--dialect or --interpreter: LinuxCNC reads its own");
        options.gcode.dialect =
            static_cast<ref::Dialect>(choice("--dialect", raw.dialect, ref::kDialectNames));
    }
    options.arc_tolerance = arc_tolerance(raw, options.points.fit);
    if (!raw.core.empty() && !raw.board.empty()) {
        throw UsageError("--core or --board: a board has its core");
    }
    CoreFile core;
    if (!raw.core.empty()) {
        core = read_core_file(raw.core);
        options.core = core.parameters;
        options.splines_set = options.aux_axes_set = true;
        options.device = core.device;
    }
    std::string segment_queue = raw.segment_queue;
    std::string profile_queue = raw.profile_queue;
    if (!raw.board.empty()) {
        const BoardFile board = read_board_file(raw.board);
        core = board.core;
        options.core = core.parameters;
        options.splines_set = options.aux_axes_set = true;
        segment_queue = std::to_string(board.segment_queue_words);
        profile_queue = std::to_string(board.profile_queue_words);
    }
    if (!raw.unit.empty()) core.unit_mm = unit_of(raw.unit);
    options.unit_mm = core.unit_mm.value_or(options.unit_mm);
    options.sample_period_s = core.sample_period_s.value_or(options.sample_period_s);
    if (!raw.sample_period.empty()) {
        options.sample_period_s = duration("--sample-period", raw.sample_period);
    }
    if (!(options.sample_period_s >= 1e-8 && options.sample_period_s <= 1)) {
        throw UsageError("--sample-period must be in [10ns, 1s]");
    }
    options.samples_per_tick = power_of_two("--samples-per-tick", raw.samples_per_tick, 1, 32768);
    options.segment_queue_words =
        power_of_two("--segment-queue", segment_queue, 64, ref::kBoardSegmentWords);
    options.profile_queue_words =
        power_of_two("--profile-queue", profile_queue, 16, ref::kBoardProfileWords);
    if (!raw.device.empty()) options.device = raw.device;
    if (core.clock_hz && raw.device.empty()) set_clock(*core.clock_hz, options);
    if (!raw.clock.empty()) set_clock(frequency("--clock", raw.clock, 1e3, 1e10), options);
    if (!raw.build.empty()) options.core.build = build_of(raw.build);
    for (const std::string& text : raw.set) {
        const ref::Parameter& row = set_parameter(options.core, text);
        options.splines_set |= row.value == &CoreParameters::splines;
        options.aux_axes_set |= row.value == &CoreParameters::aux_axes;
    }
    check_built(options);
    const double error = kDefaultBound + options.core.rounding();
    options.error_limit = bound_limit(raw.error, core.error_mm.value_or(error * options.unit_mm),
                                      options.unit_mm, options.core);
    options.override_percent = quantity("--override", raw.override_percent, {{"", 0}, {"%", 0}});
    if (!(options.override_percent >= 1 && options.override_percent <= 200)) {
        throw UsageError("--override must be in [1, 200] percent");
    }
    options.trace_clocks = whole("--trace-clocks", raw.trace_clocks);
    if (!raw.rows.empty()) options.most_rows = whole("--rows", raw.rows);
    if (options.most_rows == 0) throw UsageError("--rows must be at least 1");
    options.board = static_cast<BoardKind>(choice("--on", raw.on, kBoardNames));
    set_system(raw.system, options);
    if (!options.needs_rtl() && !raw.stall_seed.empty()) {
        throw UsageError("--stall is for --on rtl and systemc-rtl");
    }
    if (options.trace && options.board == BoardKind::kKernel) {
        throw UsageError("--trace is for --on rtl, systemc and systemc-rtl");
    }
    if (!raw.stall_seed.empty()) options.stall_seed = whole("--stall", raw.stall_seed);
}

}  // namespace curvecore::sysc
