// SPDX-License-Identifier: Apache-2.0
// explore.svg: a map for each sample period, bus and host, profile queue over segment queue.
#include <fmt/format.h>

#include <algorithm>

#include "sysc/system/explore_report.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kCellWidth = 96;
constexpr int kCellHeight = 24;
constexpr int kNames = 60;   // beside a map
constexpr int kTitles = 50;  // above it
constexpr int kMargin = 20;
constexpr std::array<const char*, 4> kColours{"#bfe3cf", "#f6e3a8", "#f2b8b0", "#d5d9de"};

std::string text(int x, int y, const char* anchor, const std::string& words) {
    return fmt::format("<text x='{}' y='{}' text-anchor='{}'>{}</text>\n", x, y, anchor, words);
}

int place_of(const std::vector<int>& queue, int words) {
    return static_cast<int>(std::find(queue.begin(), queue.end(), words) - queue.begin());
}

std::string cell(int x, int y, const ExplorePoint& point, bool chosen) {
    const auto fate = static_cast<std::size_t>(point.fate);
    return fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='{}' stroke='{}'/>\n",
                       x + 1, y + 1, kCellWidth - 3, kCellHeight - 3, kColours[fate],
                       chosen ? "#1b2430" : "none") +
           text(x + kCellWidth / 2, y + 16, "middle",
                fmt::format("{} {:.4g} s", kFateNames[fate], point.duration_s));
}

/// The longest profile queue on top.
std::string map(int x, int y, const ExploreGrid& grid, const ExploreRow& row) {
    const Surroundings& at = row.surroundings;
    std::string svg = text(x, y - 28, "start",
                           fmt::format("host {}, {} a word, samples of {}", short_time(at.host_s),
                                       short_time(at.word_s), short_time(at.sample_s)));
    const auto height = static_cast<int>(grid.profile_queue.size());
    for (const int words : grid.segment_queue) {
        const int middle = x + place_of(grid.segment_queue, words) * kCellWidth + kCellWidth / 2;
        svg += text(middle, y - 8, "middle", fmt::format("{}", words));
    }
    for (const int words : grid.profile_queue) {
        const int top = y + (height - 1 - place_of(grid.profile_queue, words)) * kCellHeight;
        svg += text(x - 8, top + 16, "end", fmt::format("{}", words));
    }
    const std::optional<ExplorePoint> answer = row.answer();
    for (const ExplorePoint& point : row.points) {
        const int column = place_of(grid.segment_queue, point.segment_queue);
        const int line = height - 1 - place_of(grid.profile_queue, point.profile_queue);
        const bool chosen = answer && answer->segment_queue == point.segment_queue &&
                            answer->profile_queue == point.profile_queue;
        svg += cell(x + column * kCellWidth, y + line * kCellHeight, point, chosen);
    }
    return svg;
}

}  // namespace

std::string ExploreReport::svg() const {
    const auto columns = static_cast<int>(grid.host_s.size());
    const int width = kNames + static_cast<int>(grid.segment_queue.size()) * kCellWidth + kMargin;
    const int height =
        kTitles + static_cast<int>(grid.profile_queue.size()) * kCellHeight + kMargin;
    std::string body = text(kMargin, 20, "start",
                            "profile queue over segment queue, words; framed: the fewest that fit");
    for (int n = 0; n < static_cast<int>(rows.size()); ++n) {
        body += map(kMargin + kNames + n % columns * width, 20 + kTitles + n / columns * height,
                    grid, rows[static_cast<std::size_t>(n)]);
    }
    return fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
        "font-family='sans-serif' font-size='12' fill='#1b2430'>\n"
        "<rect width='{0}' height='{1}' fill='#ffffff'/>\n{2}</svg>\n",
        kMargin + columns * width, 20 + static_cast<int>(rows.size()) / columns * height, body);
}

}  // namespace curvecore::sysc
