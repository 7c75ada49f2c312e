// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/compare_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sysc/host/number_list.hpp"
#include "sysc/host/usage_error.hpp"
#include "sysc/widths/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

int single(const std::string& option, const std::string& text, int low, int high) {
    const std::vector<int> numbers = number_list(option, text, low, high);
    if (numbers.size() > 1) {
        throw UsageError(fmt::format("{} '{}': one number is expected", option, text));
    }
    return numbers.front();
}

std::vector<ParameterList> lists_of(const std::vector<std::string>& set, bool core_given) {
    std::vector<ParameterList> lists;
    for (const std::string& text : set) {
        const ParameterList list = read_parameter(text);
        for (const auto value : {&CoreParameters::splines, &CoreParameters::aux_axes}) {
            if (list.row->value == value) {
                throw UsageError(fmt::format("--set {}: follows the curves", list.row->name));
            }
        }
        lists.push_back(list);
    }
    if (core_given) return lists;
    for (const char* text : kComparedSets) {
        const ParameterList list = read_parameter(text);
        const bool given = std::any_of(lists.begin(), lists.end(), [&](const ParameterList& one) {
            return one.row->value == list.row->value;
        });
        if (!given) lists.push_back(list);
    }
    return lists;
}

CurveSet curve_set(const std::string& name) {
    const auto found = std::find(kCurveSets.begin(), kCurveSets.end(), name);
    if (found == kCurveSets.end()) {
        throw UsageError(
            fmt::format("--curves '{}': must be one of {}", name, fmt::join(kCurveSets, ", ")));
    }
    return static_cast<CurveSet>(found - kCurveSets.begin());
}

}  // namespace

void interpret(const RawCompareOptions& raw, CompareOptions& options) {
    const Options& common = options.common;
    options.settings = all_combinations(common.core, lists_of(raw.set, raw.core_given));
    options.curves = curve_set(raw.curves);
    if (!options.common.file.empty() && raw.curves != RawCompareOptions().curves) {
        throw UsageError("--curves is for a comparison without FILE");
    }
    if (options.common.file.empty() && !options.common.machine.empty()) {
        throw UsageError("--machine is for a comparison with FILE");
    }
    options.sweep.unit_mm = options.common.unit_mm;
    options.sweep.limit = common.error_limit;
    options.sweep.times_segments = single("--segments", raw.segments, 1, 1000);
    options.sweep.samples = single("--samples", raw.samples, 100, 10000000);
    options.sweep.device = device_of(common.device.empty() ? kComparedDevice : common.device);
    options.sweep.quiet = options.common.quiet;
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

}  // namespace curvecore::sysc
