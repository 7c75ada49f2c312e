// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/panel_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace curvecore::sysc {
namespace {

/// Minutes and seconds.
std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(std::ceil(seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

double share(const PanelStatus& status) {
    return status.planned_mm > 0 ? status.path_mm / status.planned_mm : 0;
}

std::string places(const PanelStatus& status) {
    std::string text;
    for (const PanelAxis& axis : status.axes) {
        text += fmt::format("{} {:9.3f}  ", axis.name, axis.place_mm);
    }
    return text + "mm";
}

std::string queues(const PanelStatus& status) {
    std::string text;
    for (const PanelQueue& queue : status.queues) {
        text += fmt::format("{} {} of {}  ", queue.name, queue.waiting, queue.words);
    }
    return text + "words";
}

std::string outputs(const PanelOutputs& outputs) {
    std::string on;
    for (int bit = 0; bit < 8; ++bit) on += (outputs.bits >> bit & 1) != 0 ? char('0' + bit) : '-';
    return fmt::format("  outputs {}  power {:.0f} %", on, 100 * outputs.power);
}

std::string following(const PanelStatus& status) {
    std::string text;
    for (const PanelAxis& axis : status.axes) {
        if (axis.following_mm) text += fmt::format("  {} {:.4f}", axis.name, *axis.following_mm);
    }
    return text.empty() ? text : "following error" + text + " mm";
}

}  // namespace

std::vector<std::string> panel_lines(const PanelStatus& status, std::size_t columns) {
    std::vector<std::string> lines;
    lines.push_back(places(status));
    lines.push_back(fmt::format("feed {:.0f} mm/min  override {} %  time {:.0f} %  line {}",
                                status.feed_mm_min, status.override_percent, status.rate_percent,
                                status.line));
    lines.push_back(fmt::format("{:.3f} of {:.3f} mm{}  {:.0f} %  {}{} left", status.path_mm,
                                status.planned_mm, status.all_planned ? "" : " planned so far",
                                100 * share(status), status.all_planned ? "" : "at least ",
                                clock_text(status.left_s)));
    lines.push_back(queues(status) + (status.outputs ? outputs(*status.outputs) : ""));
    if (std::string errors = following(status); !errors.empty()) lines.push_back(errors);
    lines.push_back(status.state + (status.faults.empty() ? "" : ": " + status.faults));
    if (!status.from.empty()) lines.push_back("went on --from " + status.from);
    lines.emplace_back("h hold  r resume  + - override  s stop on the path  e e-stop");
    for (std::string& line : lines) line.resize(std::min(line.size(), columns));
    return lines;
}

std::string panel_json(const PanelStatus& status) {
    nlohmann::ordered_json json;
    json["state"] = status.state;
    for (const PanelAxis& axis : status.axes) {
        nlohmann::ordered_json one;
        one["name"] = std::string(1, axis.name);
        one["place_mm"] = axis.place_mm;
        if (axis.following_mm) one["following_mm"] = *axis.following_mm;
        json["axes"].push_back(one);
    }
    json["path_mm"] = status.path_mm;
    json["planned_mm"] = status.planned_mm;
    json["all_planned"] = status.all_planned;
    json["feed_mm_min"] = status.feed_mm_min;
    json["rate_percent"] = status.rate_percent;
    json["override_percent"] = status.override_percent;
    json["left_s"] = status.left_s;
    json["line"] = status.line;
    for (const PanelQueue& queue : status.queues) {
        json["queues"].push_back(
            {{"name", queue.name}, {"waiting", queue.waiting}, {"words", queue.words}});
    }
    if (status.outputs) {
        json["outputs"] = {{"bits", status.outputs->bits}, {"power", status.outputs->power}};
    }
    json["from"] = status.from;
    if (!status.rest.empty()) json["rest"] = status.rest;
    json["faults"] = status.faults;
    return json.dump();
}

}  // namespace curvecore::sysc
