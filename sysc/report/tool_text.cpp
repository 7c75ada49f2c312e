// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/tool_text.hpp"

#include <fmt/format.h>

#include "sysc/report/limit_text.hpp"

namespace curvecore::sysc {
namespace {

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

}  // namespace curvecore::sysc
