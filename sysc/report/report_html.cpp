// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/report_html.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "sysc/cli/html_page.hpp"
#include "sysc/report/course.hpp"
#include "sysc/report/limit_text.hpp"
#include "sysc/report/report_template.hpp"

namespace curvecore::sysc {
namespace {

using Text = fmt::memory_buffer;

template <class Values, class Format>
void array(Text& text, const char* name, const Values& values, Format format) {
    fmt::format_to(std::back_inserter(text), ",\n\"{}\":[", name);
    const char* comma = "";
    for (const auto& value : values) {
        text.append(std::string_view(comma));
        format(value);
        comma = ",";
    }
    text.push_back(']');
}

void path(Text& text, const Report& report, const Pictures& pictures) {
    const auto out = std::back_inserter(text);
    const double unit = report.job.plan.unit_mm;
    const std::vector<PathPoint>& points = pictures.path();
    for (int axis = 0; axis < 3; ++axis) {
        array(text, std::array<const char*, 3>{"x", "y", "z"}[static_cast<std::size_t>(axis)],
              points,
              [&](const PathPoint& p) { fmt::format_to(out, "{:.7g}", p.point[axis] * unit); });
    }
    array(text, "feed", points, [&](const PathPoint& p) { fmt::format_to(out, "{:.4g}", p.feed); });
    array(text, "s", points, [&](const PathPoint& p) {
        fmt::format_to(out, "{:.6g}", std::ldexp(static_cast<double>(p.s), -16) * unit);
    });
    array(text, "t", points, [&](const PathPoint& p) { fmt::format_to(out, "{:.6g}", p.time); });
    array(text, "line", points, [&](const PathPoint& p) {
        fmt::format_to(out, "{}", report.job.plan.segments[p.segment].line);
    });
    array(text, "errors", pictures.errors(), [&](double e) { fmt::format_to(out, "{:.4g}", e); });
    array(text, "bounds", pictures.bounds(), [&](double b) { fmt::format_to(out, "{:.4g}", b); });
}

void envelope(Text& text, const char* name, const std::vector<Envelope>& bins) {
    const auto out = std::back_inserter(text);
    array(text, name, bins, [&](const Envelope& bin) {
        if (bin.empty()) {
            fmt::format_to(out, "null");
        } else {
            fmt::format_to(out, "[{:.4g},{:.4g}]", bin.low, bin.high);
        }
    });
}

/// Counts each code; names its first line and place.
nlohmann::ordered_json kinds_of(const ref::Events& events) {
    std::vector<std::size_t> times(events.codes().size());
    std::vector<const ref::Events::Event*> first(times.size());
    for (const ref::Events::Event& event : events.list()) {
        const auto code = static_cast<std::size_t>(event.code);
        if (times[code]++ == 0) first[code] = &event;
    }
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (std::size_t code = 0; code < times.size(); ++code) {
        rows.push_back({events.codes()[code], times[code], first[code]->line, first[code]->length});
    }
    return rows;
}

}  // namespace

std::string report_data(const Report& report, const Pictures& pictures) {
    const Job& job = report.job;
    nlohmann::ordered_json head;
    head["title"] = std::filesystem::path(job.options.file).filename().string();
    head["version"] = CURVECORE_PROGRAM_VERSION;
    head["rtl"] = report.drawn != nullptr;
    head["held"] = report.held();
    head["unit"] = unit_text(job);
    head["path_mm"] = job.path_mm();
    head["duration_s"] = report.duration_s();
    head["velocity"] = job.machine.velocity;
    if (const auto& window = pictures.window()) {
        head["window"] = {{"ms", window->seconds * 1e3},
                          {"acceleration", window->acceleration},
                          {"jerk", window->jerk}};
    }
    for (const auto& [name, value] : report.table()) head["table"].push_back({name, value});
    for (const Check& check : report.checks()) {
        head["checks"].push_back({check.name, check.held, check.detail});
    }
    if (report.drawn != nullptr) {
        std::size_t axis = 0;
        for (const std::string& name : axis_names(job)) {
            const AxisError& rounded = report.drawn->check.rounded[axis];
            const AxisError& unrounded = report.drawn->check.unrounded[axis++];
            const std::uint64_t n = report.drawn->check.samples;
            head["axes"].push_back(
                {name, rounded.max, rounded.rms(n), unrounded.max, unrounded.rms(n)});
        }
    }
    if (report.drawn != nullptr) {
        for (const auto& [name, kind] : report.drawn->check.kinds) {
            head["kinds"].push_back(
                {name, kind.error, nullptr, nullptr, kind.speed_error, kind.samples});
            if (kind.bound > 0) {
                head["kinds"].back()[2] = kind.bound;
                head["kinds"].back()[3] = kind.of_bound;
            }
        }
    }
    head["events"] = kinds_of(job.events);
    head["windows"] = limits_rows(job, report.limits);
    head["notes"] = job.machine.notes;
    head["warnings"] = job.program.warnings;
    if (head["warnings"].size() > 50)
        head["warnings"].get_ref<nlohmann::ordered_json::array_t&>().resize(50);
    std::string text = page_json(head);
    text.pop_back();  // the closing brace
    Text rest;
    path(rest, report, pictures);
    envelope(rest, "speed", pictures.speed());
    envelope(rest, "acceleration", pictures.acceleration());
    envelope(rest, "total", pictures.total_acceleration());
    envelope(rest, "jerk", pictures.jerk());
    const Course shape = course(job);
    envelope(rest, "curvature", shape.curvature);
    if (job.is_smooth()) {
        envelope(rest, "deviation", shape.deviation);
        envelope(rest, "tolerance", shape.tolerance);
    }
    const auto out = std::back_inserter(rest);
    array(rest, "outputs", shape.outputs, [&](int bits) { fmt::format_to(out, "{}", bits); });
    array(rest, "power", shape.power, [&](double share) { fmt::format_to(out, "{:.4g}", share); });
    for (std::size_t axis = 0; axis < 3; ++axis) {
        envelope(rest, std::array<const char*, 3>{"slope_x", "slope_y", "slope_z"}[axis],
                 shape.slope[axis]);
    }
    return text + fmt::to_string(rest) + "}";
}

std::string report_html(const Report& report, const Pictures& pictures) {
    return html_page(kReportTemplate, report_data(report, pictures));
}

}  // namespace curvecore::sysc
