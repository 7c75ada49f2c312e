// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/compare_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/text/input_error.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/compare/tick_comparison.hpp"
#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

/// Lists of --set, and those that are compared without it.
std::vector<ParameterList> lists_of(const CompareOptions& options) {
    std::vector<ParameterList> lists = options.set;
    for (const ParameterList& list : lists) {
        for (const auto value : {&CoreParameters::splines, &CoreParameters::aux_axes}) {
            if (list.row->value == value) {
                throw UsageError(fmt::format("--set {}: follows the curves", list.row->name));
            }
        }
    }
    if (options.core_given || !options.schemes.empty()) return lists;
    for (const char* text : kComparedSets) {
        const ParameterList list = read_parameter(text);
        const bool given = std::any_of(lists.begin(), lists.end(), [&](const ParameterList& one) {
            return one.row->value == list.row->value;
        });
        if (!given) lists.push_back(list);
    }
    return lists;
}

bool has(const std::vector<Scheme>& schemes, Scheme scheme) {
    return std::find(schemes.begin(), schemes.end(), scheme) != schemes.end();
}

/// Adds a scheme once for each combination of the values that it depends on.
void add_ticked(Scheme scheme, bool words, const CompareOptions& options, double tick, double feed,
                std::vector<TickedSetting>& ticked) {
    const std::size_t first = ticked.size();
    for (const CoreParameters& setting : options.settings) {
        const TickedSetting one{setting, {scheme, words, tick, feed}};
        const auto same = [&](const TickedSetting& other) {
            return (!one.ticks.has_order() || other.setting.order == setting.order) &&
                   (!words || other.setting.coef_bits == setting.coef_bits);
        };
        if (std::none_of(ticked.begin() + static_cast<std::ptrdiff_t>(first), ticked.end(), same)) {
            ticked.push_back(one);
        }
    }
}

void complete_schemes(CompareOptions& options) {
    const std::vector<Scheme>& schemes = options.schemes;
    for (const ParameterList& list : options.set) {
        if (list.row->value == &CoreParameters::anchor) {
            throw UsageError("--set Anchor: follows --scheme");
        }
    }
    const bool any = std::any_of(schemes.begin(), schemes.end(), is_ticked);
    if (!any && !(options.ticks.empty() && options.feeds.empty())) {
        throw UsageError("--tick and --feed are for --scheme paper, rk4 and scalar");
    }
    options.sweep.by_move = true;
    for (CoreParameters setting : options.settings) {
        for (const Scheme scheme : {Scheme::kAnchored, Scheme::kPropagated}) {
            if (!has(schemes, scheme)) continue;
            setting.anchor = scheme == Scheme::kAnchored ? 1 : 0;
            options.drawn.push_back(setting);
        }
    }
    for (const double tick : options.ticks) {
        for (const double feed : options.feeds) {
            for (const Scheme scheme : schemes) {
                if (!is_ticked(scheme)) continue;
                if (scheme == Scheme::kPaper) {
                    add_ticked(scheme, true, options, tick, feed, options.sweep.ticked);
                }
                add_ticked(scheme, false, options, tick, feed, options.sweep.ticked);
            }
        }
    }
}

}  // namespace

void complete(CompareOptions& options) {
    const Options& common = options.common;
    options.settings = all_combinations(common.core, lists_of(options));
    if (!common.file.empty() && options.curves != CurveSet::kAll) {
        throw UsageError("--curves is for a comparison without FILE");
    }
    if (common.file.empty() && !common.machine.empty()) {
        throw UsageError("--machine is for a comparison with FILE");
    }
    if (!options.schemes.empty()) {
        complete_schemes(options);
    } else if (!options.ticks.empty()) {
        throw UsageError("--tick is for --scheme paper, rk4 and scalar");
    } else {
        options.drawn = options.settings;
    }
    options.sweep.unit_mm = common.unit_mm;
    options.sweep.limit = common.error_limit;
    if (options.devices.empty()) {
        options.devices = {device_of(common.device.empty() ? kComparedDevice : common.device)};
    }
    options.sweep.device = options.devices.front();
    options.sweep.quiet = common.quiet;
}

void complete_settings(const ref::Program& program, std::vector<CoreParameters>& settings) {
    const bool splines =
        std::any_of(program.moves.begin(), program.moves.end(),
                    [](const ref::Move& move) { return move.kind == ref::Move::Kind::kCubic; });
    for (CoreParameters& setting : settings) {
        setting.aux_axes = program.aux_axes;
        setting.splines = splines ? 1 : 0;
        const std::string reason = ref::why_not_built(setting);
        if (!reason.empty()) {
            throw UsageError(
                fmt::format("there are {}splines, and {}", splines ? "" : "no ", reason));
        }
    }
}

void check_ticked(const ref::Program& program, const CompareOptions& options) {
    if (options.sweep.ticked.empty()) return;
    const std::string name = scheme_name(options.sweep.ticked.front().ticks.scheme);
    for (const ref::Move& move : program.moves) {
        if (move.kind == ref::Move::Kind::kCubic) continue;
        if (options.common.file.empty()) {
            throw UsageError(
                fmt::format("--scheme {} draws splines only: --curves splines or papers", name));
        }
        throw ref::InputError(program.file, move.line,
                              fmt::format("no spline, and --scheme {} draws nothing else", name));
    }
    constexpr double kMostTicks = 1e7;
    for (const TickedSetting& one : options.sweep.ticked) {
        const double ticks = ticks_of(program, one.ticks);
        if (ticks <= kMostTicks) continue;
        throw UsageError(
            fmt::format("--tick {:g}ms at --feed {:g}m/min: {:.2g} ticks, {:g} are "
                        "the most",
                        one.ticks.tick * 1e3, one.ticks.feed * 60e-3, ticks, kMostTicks));
    }
}

}  // namespace curvecore::sysc
