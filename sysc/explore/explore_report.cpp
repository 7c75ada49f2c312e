// SPDX-License-Identifier: Apache-2.0
#include "sysc/explore/explore_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "sysc/cli/html_page.hpp"
#include "sysc/explore/explore_template.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

std::string_view fate_name(Fate fate) { return kFateNames[static_cast<std::size_t>(fate)]; }

Json json_of(const ExplorePoint& point) {
    return {{"segment_queue", point.segment_queue},
            {"profile_queue", point.profile_queue},
            {"fate", fate_name(point.fate)},
            {"duration_s", point.duration_s},
            {"stop_s", point.stop_s}};
}

Json json_of(const std::vector<ExplorePoint>& points) {
    Json all = Json::array();
    for (const ExplorePoint& point : points) all.push_back(json_of(point));
    return all;
}

/// Reasons why no pair fits.
std::string fates_text(const std::vector<ExplorePoint>& points) {
    std::string text;
    for (const Fate fate : {Fate::kSlows, Fate::kHolds, Fate::kNeverBegins}) {
        const auto count = std::count_if(points.begin(), points.end(),
                                         [&](const ExplorePoint& one) { return one.fate == fate; });
        if (count == 0) continue;
        text += fmt::format("{}{} {}", text.empty() ? "none: " : ", ", fate_name(fate), count);
    }
    return text;
}

}  // namespace

bool ExploreReport::answered() const {
    return std::any_of(rows.begin(), rows.end(),
                       [](const ExploreRow& row) { return row.answer().has_value(); });
}

std::string ExploreReport::table() const {
    std::string text =
        "sample period  word     host     segment queue  profile queue  duration   a hold takes\n";
    for (const ExploreRow& row : rows) {
        const Surroundings& at = row.surroundings;
        const std::string times = fmt::format("{:<14} {:<8} {:<8} ", short_time(at.sample_s),
                                              short_time(at.word_s), short_time(at.host_s));
        const std::optional<ExplorePoint> answer = row.answer();
        text += times;
        text +=
            answer ? fmt::format("{:<14} {:<14} {:<10} {}\n", answer->segment_queue,
                                 answer->profile_queue, fmt::format("{:.3f} s", answer->duration_s),
                                 fmt::format("{:.3f} s", answer->stop_s))
                   : fates_text(row.points) + "\n";
    }
    return text;
}

nlohmann::ordered_json ExploreReport::json() const {
    Json json;
    json["input"] = job.options.file;
    json["jitter_s"] = job.options.system.jitter_s;
    json["segment_queues"] = grid.segment_queue;
    json["profile_queues"] = grid.profile_queue;
    json["rows"] = Json::array();
    for (const ExploreRow& row : rows) {
        const Surroundings& at = row.surroundings;
        const std::optional<ExplorePoint> answer = row.answer();
        json["rows"].push_back({{"sample_period_s", at.sample_s},
                                {"word_s", at.word_s},
                                {"host_s", at.host_s},
                                {"answer", answer ? json_of(*answer) : Json()},
                                {"points", json_of(row.points)}});
    }
    json["warnings"] = job.program.warnings;
    return json;
}

std::string ExploreReport::html() const {
    Json data = json();
    data["title"] = std::filesystem::path(job.options.file).filename().string();
    data["version"] = CURVECORE_PROGRAM_VERSION;
    return html_page(kExploreTemplate, page_json(data));
}

std::string short_time(double seconds) {
    for (const auto& [unit, size] : {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}}) {
        if (seconds >= size * (1 - 1e-9)) return fmt::format("{:.6g}{}", seconds / size, unit);
    }
    return fmt::format("{:.6g}ns", seconds * 1e9);
}

}  // namespace curvecore::sysc
