// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/queue_cover.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/planned_branches.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr std::uint64_t kOnTheWay = 64;  // ticks between what the guard counts and what is so
constexpr double kSlower = 0.9;           // of the speed that would just do: pieces are whole ticks

/// Path, ticks and words at the ends of frames of one stream.
struct Ends {
    std::vector<std::uint64_t> path{0};
    std::vector<std::uint64_t> ticks{0};
    std::vector<std::size_t> words{0};

    void add(std::uint64_t length, std::uint32_t time, std::size_t count) {
        path.push_back(path.back() + length);
        ticks.push_back(ticks.back() + time);
        words.push_back(words.back() + count);
    }
};

std::uint64_t needed_ticks(const Plan& plan) {
    const auto late = static_cast<std::uint64_t>(std::ceil(kHostLate / plan.tick_s));
    return plan.stop_ticks + kOnTheWay + late;
}

/// Words of a queue that count: while the host is in time the rest is what it refills.
std::size_t room(int queue) { return static_cast<std::size_t>(queue) * 3 / 4; }

/// Calls slow(path from, path to, quanta, ticks) for every run of frames, one after the other on
/// the path, that three quarters of a queue of `queue` words hold and that is over in fewer ticks
/// than `needed`.
template <class Slow>
void each_short_run(const Ends& ends, int queue, std::uint64_t needed, Slow slow) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < ends.words.size(); ++i) {
        while (end + 1 < ends.words.size() && ends.words[end + 1] - ends.words[i] <= room(queue)) {
            ++end;
        }
        if (end + 1 == ends.words.size()) return;
        const std::uint64_t ticks = ends.ticks[end] - ends.ticks[i];
        if (ticks < needed) slow(ends.path[i], ends.path[end], ticks);
    }
}

}  // namespace

double covered_words(const PlanOptions& options, const Plan& plan) {
    return static_cast<double>(room(options.profile_queue_words)) /
           static_cast<double>(needed_ticks(plan));
}

std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          bool evens, std::vector<double>& speeds) {
    Ends segments;
    const auto segment_words = static_cast<std::size_t>(segment_bus_words(options.aux_axes));
    for (const Segment& segment : plan.segments) {
        segments.add(segment.length, segment.ticks, segment_words);
    }
    Ends pieces;
    auto branch = plan.branches.begin();
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
        std::size_t words = kProfileBusWords;
        if (branch != plan.branches.end() && branch->piece == i) words += branch_words(*branch++);
        pieces.add(plan.pieces[i].ds, plan.pieces[i].ticks, words);
    }
    std::vector<std::uint64_t> ends;  // of planned moves
    std::uint64_t path = 0;
    for (const PlannedMove& move : geometry.moves) ends.push_back(path += move.length);

    const std::uint64_t needed = needed_ticks(plan);
    std::vector<bool> slowed(speeds.size(), false);
    const auto slow = [&](std::uint64_t from, std::uint64_t to, std::uint64_t ticks) {
        const double length = static_cast<double>(to - from) / 65536 * plan.unit_mm;
        const double mean = length / (static_cast<double>(ticks) * plan.tick_s);
        const double covered = kSlower * length / (static_cast<double>(needed) * plan.tick_s);
        const double speed = evens ? mean : covered;
        const auto first = std::upper_bound(ends.begin(), ends.end(), from) - ends.begin();
        for (auto i = static_cast<std::size_t>(first); i < ends.size(); ++i) {
            if (speed < speeds[i]) {
                speeds[i] = speed;
                slowed[i] = true;
            }
            if (ends[i] >= to) break;
        }
    };
    each_short_run(segments, options.segment_queue_words, needed, slow);
    each_short_run(pieces, options.profile_queue_words, needed, slow);
    return static_cast<std::size_t>(std::count(slowed.begin(), slowed.end(), true));
}

}  // namespace curvecore::ref
