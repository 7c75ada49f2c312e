// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/options/core_options.hpp"

#include <algorithm>
#include <cmath>

#include "ref/format/queues.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/core/board_file.hpp"
#include "sysc/cost/device.hpp"

namespace curvecore::sysc {
namespace {

/// Default limit of the worst error of a position on any axis, before rounding, in units.
constexpr double kDefaultBound = 0.1;

const auto kSegmentQueue = power_of_two_in(64, ref::kBoardSegmentWords);
const auto kProfileQueue = power_of_two_in(16, ref::kBoardProfileWords);

/// Returns a sample period, s, of the command line or of a file. @throws UsageError
double checked_period(double period) {
    if (period >= 1e-8 && period <= 1) return period;
    throw UsageError("--sample-period must be in [10ns, 1s]");
}

double period_of(const std::string& option, const std::string& text) {
    return checked_period(duration(option, text));
}

/// Checks that the core is built, with or without splines while that is open.
void check_built(const Options& options) {
    CoreParameters core = options.core;
    const std::string reason = ref::why_not_built(core);
    if (!options.splines_set) core.splines = 1;
    if (!ref::legal(core) && !reason.empty()) throw UsageError(reason);
}

/// Returns the derived bound, before rounding, that keeps an error, in units.
double bound_limit(double error_mm, double unit_mm, const CoreParameters& core) {
    // so that 0.6 - 0.5 is 0.1
    const double limit = std::round((error_mm / unit_mm - core.rounding()) * 1e9) / 1e9;
    if (!(limit >= 0.001 && limit <= 1e6)) {
        throw UsageError(fmt::format(
            "--error {}: must be in [0.501, 1000000] units of {}; half a unit is lost by rounding",
            exact_length(error_mm), exact_length(unit_mm)));
    }
    return limit;
}

}  // namespace

void CoreChoice::apply(Options& options) {
    CoreFile file;
    if (!core.empty() && !board.empty()) {
        throw UsageError("--core or --board: a board has its core");
    }
    if (!core.empty()) {
        file = read_core_file(core);
        options.device = file.device;
    }
    if (!board.empty()) {
        const BoardFile read = read_board_file(board);
        file = read.core;
        segment_queues_words = {
            kSegmentQueue("--segment-queue", std::to_string(read.segment_queue_words))};
        profile_queues_words = {
            kProfileQueue("--profile-queue", std::to_string(read.profile_queue_words))};
    }
    if (!core.empty() || !board.empty()) {
        options.core = file.parameters;
        options.splines_set = options.aux_axes_set = true;
    }
    const auto either = [](const std::optional<double>& first, const std::optional<double>& then,
                           double otherwise) { return first ? *first : then.value_or(otherwise); };
    options.unit_mm = either(said.unit_mm, file.unit_mm, options.unit_mm);
    options.sample_period_s =
        sample_periods_s.empty()
            ? checked_period(file.sample_period_s.value_or(options.sample_period_s))
            : *std::min_element(sample_periods_s.begin(), sample_periods_s.end());
    const auto longest = [](const std::vector<int>& words, int otherwise) {
        return words.empty() ? otherwise : *std::max_element(words.begin(), words.end());
    };
    options.segment_queue_words = longest(segment_queues_words, options.segment_queue_words);
    options.profile_queue_words = longest(profile_queues_words, options.profile_queue_words);
    if (!said.device.empty()) {
        options.device = said.device;
        file.clock_hz.reset();  // the device's stands
    }
    options.clock_set = said.clock_hz || file.clock_hz;
    options.clock_hz = either(said.clock_hz, file.clock_hz, options.clock_hz);
    options.core.build = build.value_or(options.core.build);
    for (const ParameterList& list : set) {
        list.set(options.core);
        options.splines_set |= list.row->value == &CoreParameters::splines;
        options.aux_axes_set |= list.row->value == &CoreParameters::aux_axes;
    }
    check_built(options);
    const double error = (kDefaultBound + options.core.rounding()) * options.unit_mm;
    options.error_limit =
        bound_limit(either(said.error_mm, file.error_mm, error), options.unit_mm, options.core);
}

void add_core(CLI::App& command, CoreChoice& core) {
    begin_group(command, group::kCore);
    add_text(command, "--core", core.core, "FILE.json",
             "a core as choose writes it: parameters, unit, error, sample period, clock");
    add_value(command, "--build", core.build, "BUILD",
              "parallel (default), engine, or serial: a curve core alone", build_of);
    add_value(command, "--device", core.said.device, "NAME", device_names(),
              [](const std::string& option, const std::string& text) {
                  if (text.empty()) throw UsageError(option + " '': a name is expected");
                  return text;
              });
    add_value(command, "--error", core.said.error_mm, "LENGTH",
              fmt::format("worst error of a position on any axis, half a unit of rounding in it; "
                          "default {:g} units",
                          kDefaultBound + CoreParameters().rounding()),
              in_range(length, 1e-7, 1e3));
}

void add_clocks(CLI::App& command, CoreChoice& core, Options& options, const TimedValues& values) {
    add_text(command, "--board", core.board, "NAME",
             "one of scripts/boards, or a file of such: its core, clock, sample period and "
             "queues");
    add_value(command, "--sample-period", core.sample_periods_s, "TIME",
              "time between samples; default 100us", list_of(period_of, values.lists));
    add_value(command, "--samples-per-tick", options.samples_per_tick, "N",
              "samples that share a tick of the feed profile, 2^n", power_of_two_in(1, 32768))
        ->default_val(options.samples_per_tick)
        ->group(group::kRare);
    add_value(command, "--segment-queue", core.segment_queues_words, "WORDS",
              "SegmentQueueWords of the core: what is queued outlasts a stop, or moves are slowed",
              list_of(kSegmentQueue, values.lists))
        ->default_val(values.segment_queue);
    add_value(command, "--profile-queue", core.profile_queues_words, "WORDS",
              "ProfileQueueWords of it", list_of(kProfileQueue, values.lists))
        ->default_val(values.profile_queue);
    add_value(
        command, "--clock", core.said.clock_hz, "FREQUENCY",
        "the core's clock, which its steps are timed by; default 100MHz, or with --device its "
        "estimate there",
        in_range(frequency, 1e3, 1e10));
    add_values(command, "--set", core.set, "NAME=VALUE",
               "a parameter of the core: " + ref::parameter_names(),
               [](const std::string&, const std::string& text) { return single_parameter(text); });
}

}  // namespace curvecore::sysc
