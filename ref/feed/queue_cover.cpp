// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/queue_cover.hpp"

#include <algorithm>

#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr std::uint64_t kOnTheWay = 128;  // ticks between what the guard counts and what is so
constexpr double kSlower = 0.9;           // of the speed that would just do: pieces are whole ticks

/// Path and ticks at the ends of frames of one stream.
struct Ends {
    std::vector<std::uint64_t> path{0};
    std::vector<std::uint64_t> ticks{0};

    void add(std::uint64_t length, std::uint32_t time) {
        path.push_back(path.back() + length);
        ticks.push_back(ticks.back() + time);
    }
};

/// Calls slow(path from, path to, quanta; ticks) for every run of `count` frames, one after the
/// other on the path, that is over in fewer ticks than `needed`.
template <class Slow>
void each_short_run(const Ends& ends, std::size_t count, std::uint64_t needed, Slow slow) {
    for (std::size_t i = 0; i + count < ends.ticks.size() - 1; ++i) {
        if (ends.ticks[i + count] - ends.ticks[i] < needed) {
            slow(ends.path[i], ends.path[i + count]);
        }
    }
}

}  // namespace

std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          std::vector<double>& speeds) {
    Ends segments;
    for (const Segment& segment : plan.segments) segments.add(segment.length, segment.ticks);
    Ends pieces;
    for (const ProfilePiece& piece : plan.pieces) pieces.add(piece.ds, piece.ticks);
    std::vector<std::uint64_t> ends;  // of planned moves
    std::uint64_t path = 0;
    for (const PlannedMove& move : geometry.moves) ends.push_back(path += move.length);

    const std::uint64_t needed = plan.stop_ticks + kOnTheWay;
    const double seconds = static_cast<double>(needed) * plan.tick_s;
    std::vector<bool> slowed(speeds.size(), false);
    const auto slow = [&](std::uint64_t from, std::uint64_t to) {
        const double length = static_cast<double>(to - from) / 65536 * plan.unit_mm;
        const double speed = kSlower * length / seconds;
        const auto first = std::upper_bound(ends.begin(), ends.end(), from) - ends.begin();
        for (auto i = static_cast<std::size_t>(first); i < ends.size(); ++i) {
            if (speed < speeds[i]) {
                speeds[i] = speed;
                slowed[i] = true;
            }
            if (ends[i] >= to) break;
        }
    };
    const auto frames = [](int words, int each) {
        return static_cast<std::size_t>(words / each * 3 / 4);
    };
    const int segment = segment_bus_words(plan.aux_axes);
    each_short_run(segments, frames(options.segment_queue_words, segment), needed, slow);
    each_short_run(pieces, frames(options.profile_queue_words, kProfileBusWords), needed, slow);
    return static_cast<std::size_t>(std::count(slowed.begin(), slowed.end(), true));
}

}  // namespace curvecore::ref
