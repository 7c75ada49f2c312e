// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/limit_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sysc/report/report.hpp"

namespace curvecore::sysc {
namespace {

int line_of(const Job& job, const LimitLoads::Worst& worst) {
    return job.plan.segments[worst.segment].line;
}

std::string limited_name(const Job& job, std::size_t of) {
    return of == 0 ? "path" : axis_names(job)[of - 1];
}

double seconds(const Job& job, const LimitLoads::Worst& worst) {
    return static_cast<double>(worst.sample) * job.options.sample_period_s;
}

std::string_view shaper_of(const Job& job) {
    return ref::kShaperNames[static_cast<std::size_t>(job.machine.shaper)];
}

nlohmann::ordered_json path_json(const ToolPath& path) {
    return {{"off_mm", path.off}, {"rest_mm", path.rest}};
}

std::string path_text(const ToolPath& path) {
    return fmt::format("{:.3g} um off the path, {:.3g} um at rest", 1e3 * path.off,
                       1e3 * path.rest);
}

}  // namespace

nlohmann::ordered_json limits_json(const Job& job, const LimitLoads& limits) {
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < kLimitedNames.size(); ++i) {
        json[kLimitedNames[i]] = nullptr;
        if (limits.resolved()) json[kLimitedNames[i]] = limits.worst[i].ratio;
    }
    for (std::size_t i = 0; i < kLimitedNames.size() && limits.resolved(); ++i) {
        const LimitLoads::Worst& worst = limits.worst[i];
        json["worst"][kLimitedNames[i]] = {{"of", limited_name(job, worst.of)},
                                           {"window_s", worst.window},
                                           {"at_s", seconds(job, worst)},
                                           {"line", line_of(job, worst)}};
    }
    for (const WindowLoads& window : limits.windows) {
        nlohmann::ordered_json row{{"window_s", window.seconds}};
        for (std::size_t of = 0; of <= axis_names(job).size(); ++of) {
            nlohmann::ordered_json& ratios = row[limited_name(job, of)];
            for (std::size_t i = 0; i < kLimitedNames.size() && !window.of.empty(); ++i) {
                ratios[kLimitedNames[i]] = window.of[of][i];
            }
        }
        json["windows"].push_back(row);
    }
    return json;
}

std::string limits_text(const Job& job, const LimitLoads& limits) {
    if (!limits.resolved()) {
        return fmt::format("not measured: no window of {:g} ms or less has {} ticks",
                           kLimitWindows.back() * 1e3, kLeastTicks);
    }
    const auto worst = std::max_element(
        limits.worst.begin(), limits.worst.end(),
        [](const LimitLoads::Worst& a, const LimitLoads::Worst& b) { return a.ratio < b.ratio; });
    return fmt::format("{:.3f} of the {} allowed to {} over {:g} ms, at {:.4f} s, line {}",
                       worst->ratio,
                       kLimitedNames[static_cast<std::size_t>(worst - limits.worst.begin())],
                       limited_name(job, worst->of), worst->window * 1e3, seconds(job, *worst),
                       line_of(job, *worst));
}

nlohmann::ordered_json limits_rows(const Job& job, const LimitLoads& limits) {
    nlohmann::ordered_json rows;
    for (const WindowLoads& window : limits.windows) {
        for (std::size_t of = 0; of < window.of.size(); ++of) {
            nlohmann::ordered_json row{window.seconds * 1e3, limited_name(job, of)};
            for (const double ratio : window.of[of]) row.push_back(ratio);
            rows.push_back(row);
        }
    }
    return rows;
}

nlohmann::ordered_json tool_json(const Job& job, const ToolResult& tool) {
    nlohmann::ordered_json json{{"shaper", shaper_of(job)}, {"without", path_json(tool.without)}};
    if (job.machine.shaper == ref::ShaperKind::kNone) return json;
    json["shaped"] = path_json(tool.shaped);
    json["delay_s"] = tool.delay_s;
    json["drives"] = limits_json(job, tool.drives);
    return json;
}

std::string tool_text(const Job& job, const ToolResult& tool) {
    const std::string without = path_text(tool.without);
    if (job.machine.shaper == ref::ShaperKind::kNone) return without + ", without a shaper";
    return fmt::format("{} with {}; {} without; {:g} ms late; drives at {}", path_text(tool.shaped),
                       shaper_of(job), without, 1e3 * tool.delay_s, limits_text(job, tool.drives));
}

nlohmann::ordered_json ratios_json(const ref::LimitRatios& ratios) {
    return {{"velocity", ratios.velocity},
            {"acceleration", ratios.acceleration},
            {"jerk", ratios.jerk}};
}

nlohmann::ordered_json joints_json(const Job& job, const CheckResult& check) {
    return {{"kinematics", ref::name_of(job.machine.kinematics)},
            {"tool_off_mm", check.tool_off},
            {"of_bound", check.tool_of_bound}};
}

std::string joints_text(const Job& job, const CheckResult& check) {
    return fmt::format("{}: off by {:.3g} nm at most, {:.3f} of what its joints' bounds allow",
                       ref::name_of(job.machine.kinematics), check.tool_off * 1e6,
                       check.tool_of_bound);
}

}  // namespace curvecore::sysc
