// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/step_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace curvecore::sysc {
namespace {

bool good(const AxisStatus& axis) {
    return axis.count == axis.due && !axis.overrun && !axis.refused;
}

template <class Text>
std::string each_axis(const StepStatus& steps, const std::vector<std::string>& axes, Text&& text) {
    std::string all;
    for (std::size_t a = 0; a < steps.axes.size(); ++a) {
        all += fmt::format("{}{} {}", a == 0 ? "" : ", ", axes[a], text(steps.axes[a]));
    }
    return all;
}

}  // namespace

bool every_step_given(const StepStatus& steps) {
    return std::all_of(steps.axes.begin(), steps.axes.end(), good);
}

nlohmann::ordered_json steps_json(const StepStatus& steps, const std::vector<std::string>& axes) {
    nlohmann::ordered_json json;
    json["clock_hz"] = steps.clock_hz;
    json["pins"] = fmt::format("{:016x}", steps.pins);
    for (std::size_t a = 0; a < steps.axes.size(); ++a) {
        const AxisStatus& axis = steps.axes[a];
        json["axes"][axes[a]] = {{"steps", axis.steps},
                                 {"turns", axis.turns},
                                 {"count", axis.count},
                                 {"due", axis.due},
                                 {"overrun", axis.overrun},
                                 {"refused", axis.refused},
                                 {"following_error_mm", axis.following_error_mm}};
    }
    return json;
}

std::string steps_text(const StepStatus& steps, const std::vector<std::string>& axes) {
    return each_axis(steps, axes, [](const AxisStatus& axis) {
        std::string text = fmt::format("{}", axis.steps);
        if (axis.count != axis.due) text += fmt::format(" ({} lost)", axis.due - axis.count);
        if (axis.overrun) text += " (overrun)";
        if (axis.refused) text += " (too fast)";
        return text;
    });
}

std::string following_error_text(const StepStatus& steps, const std::vector<std::string>& axes) {
    return each_axis(steps, axes,
                     [](const AxisStatus& axis) {
                         return fmt::format("{:.3f}", axis.following_error_mm);
                     }) +
           " mm at most";
}

}  // namespace curvecore::sysc
