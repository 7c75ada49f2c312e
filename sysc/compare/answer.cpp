// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/answer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

/// Worst error of a position that is proven: the derived bound and the rounding, mm.
double proven_mm(const Row& row, const CompareOptions& options) {
    return (row.bound.value_or(0) + row.setting.rounding()) * options.common.unit_mm;
}

double asked_mm(const CompareOptions& options) {
    return (options.sweep.limit + options.common.core.rounding()) * options.common.unit_mm;
}

bool keeps(const Row& row, const CompareOptions& options) {
    return row.drawn && !row.ticks && row.missing_bits == 0 && row.held() && row.bound &&
           row.limit == options.sweep.limit;
}

std::string length_text(double mm) {
    return mm < 1e-3 ? fmt::format("{:.3g} nm", mm * 1e6)
           : mm < 1  ? fmt::format("{:.3g} um", mm * 1e3)
                     : fmt::format("{:.3g} mm", mm);
}

std::string size_text(const CostEstimate& cost, const Device& device) {
    std::string text =
        fmt::format("some {:.0f} {}, {} DSP", cost.lut4, device.lut_name(), cost.dsp);
    if (cost.mhz) text += fmt::format(", {:.0f} MHz", *cost.mhz);
    return text;
}

/// The parameters that differ among the configurations, or all where none does.
std::string setting_text(const CoreParameters& setting, const CompareOptions& options) {
    const auto same = [&](const ref::Parameter* one) {
        return std::all_of(options.settings.begin(), options.settings.end(),
                           [&](const CoreParameters& other) {
                               return other.*one->value == options.settings.front().*one->value;
                           });
    };
    std::vector<const ref::Parameter*> columns = columns_of(options.settings);
    if (!std::all_of(columns.begin(), columns.end(), same)) {
        columns.erase(std::remove_if(columns.begin(), columns.end(), same), columns.end());
    }
    std::string text;
    for (const ref::Parameter* one : columns) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", one->name, setting.*one->value);
    }
    return text;
}

}  // namespace

std::vector<Answer> answers(const CompareOptions& options, const ref::Program& program,
                            const SweepResult& result) {
    const auto is_spline = [](const ref::Move& move) {
        return move.kind == ref::Move::Kind::kCubic;
    };
    const auto& moves = program.moves;
    const bool splines = std::any_of(moves.begin(), moves.end(), is_spline);
    const bool arcs = !std::all_of(moves.begin(), moves.end(), is_spline);
    std::vector<Answer> all;
    for (const Device* device : options.devices) {
        Answer answer;
        answer.device = device;
        for (const Row& row : result.rows) {
            if (!keeps(row, options)) continue;
            ++answer.keep;
            for (const Build build : options.builds) {
                AnswerCore core{&row, core_for(arcs, splines, build), row.setting, {}};
                core.parameters.build = build;
                core.parameters.multiplier_form = device->form;
                if (!ref::why_not_built(core.parameters).empty()) continue;
                const auto cost = estimate(core.core, core.parameters, *device);
                if (!cost || !cost->fits(*device)) continue;
                core.cost = *cost;
                ++answer.fit;
                const auto size = [&](const AnswerCore& of) { return of.cost.size(*device); };
                if (!answer.take || size(core) < size(*answer.take)) answer.take = core;
                const auto worse = [&](const AnswerCore& of) {
                    return of.row->bound > row.bound ||
                           (of.row->bound == row.bound && size(of) > size(core));
                };
                if (!answer.finest || worse(*answer.finest)) answer.finest = core;
            }
        }
        if (answer.take && answer.finest->row->bound >= answer.take->row->bound) {
            answer.finest.reset();
        }
        all.push_back(answer);
    }
    return all;
}

std::string Answer::text(const CompareOptions& options, std::size_t asked) const {
    const std::string error = length_text(asked_mm(options));
    const std::string all = fmt::format("{} of {} configurations keep {}", keep, asked, error);
    if (!take) {
        if (keep == 0) {
            return fmt::format("{}: {}: take more CoefBits or a higher Order, or ask for less\n",
                               device->name, all);
        }
        const bool known =
            std::any_of(options.builds.begin(), options.builds.end(),
                        [&](const Build build) { return cost_is_known(build, *device); });
        return fmt::format("{}: {}, {}\n", device->name, all,
                           known ? "and none of them fits: take a larger device"
                                 : "but no runs of such a core were measured for it");
    }
    std::string text = fmt::format(
        "{}: take {}, {} build: proven to {} with {} segments, {}; {}, and this is the smallest\n",
        device->name, setting_text(take->parameters, options), build_name(take->parameters.build),
        length_text(proven_mm(*take->row, options)), take->row->segments,
        size_text(take->cost, *device), all);
    if (finest) {
        const double more = 100 * (finest->cost.size(*device) / take->cost.size(*device) - 1);
        text +=
            fmt::format("{:{}}  {}, {} build, is proven to {} for {:.0f} % more of the device\n",
                        "", device->name.size(), setting_text(finest->parameters, options),
                        build_name(finest->parameters.build),
                        length_text(proven_mm(*finest->row, options)), more);
    }
    return text;
}

CoreFile Answer::core(const CompareOptions& options) const {
    CoreFile file;
    file.core = core_name(take->core);
    file.parameters = take->parameters;
    file.device = device->name;
    file.unit_mm = options.common.unit_mm;
    file.error_mm = asked_mm(options);
    file.sample_period_s = options.common.sample_period_s;
    file.clock_hz = take->cost.reached();
    return file;
}

}  // namespace curvecore::sysc
