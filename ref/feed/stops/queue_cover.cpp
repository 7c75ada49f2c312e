// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stops/queue_cover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ref/feed/stops/planned_branches.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr std::uint64_t kOnTheWay = 64;  // ticks by which the guard's count lags
constexpr double kRampPieces = 6;        // three of a ramp, and as many that take no time
constexpr double kSlower = 0.9;          // share of the speed that suffices: pieces are whole ticks

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

Ends ends_of_segments(const Geometry& geometry, const PlanOptions& options) {
    Ends ends;
    const auto words = static_cast<std::size_t>(segment_bus_words(options.aux_axes)) +
                       static_cast<std::size_t>(options.format.further_words);
    for (const Segment& segment : geometry.segments) ends.add(segment.length, segment.ticks, words);
    return ends;
}

Ends ends_of_pieces(const Plan& plan) {
    Ends ends;
    auto branch = plan.branches.begin();
    const PlannedBranch* before = nullptr;
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
        std::size_t words = kProfileBusWords;
        if (branch != plan.branches.end() && branch->piece == i) {
            words += branch_words(*branch, before);
            before = &*branch++;
        }
        ends.add(plan.pieces[i].ds, plan.pieces[i].ticks, words);
    }
    return ends;
}

std::uint64_t needed_ticks(const Plan& plan) {
    const auto late = static_cast<std::uint64_t>(std::ceil(kHostLate / plan.tick_s));
    return plan.stop_ticks + kOnTheWay + late;
}

/// Number of a queue's words that count: the host refills the rest in time.
std::size_t room(int queue) { return static_cast<std::size_t>(queue) * 3 / 4; }

/// Calls slow(first, end), places in `ends`, for every run of frames in a row on the path that
/// fits into three quarters of a queue of `queue` words and lasts fewer ticks than `needed`.
template <class Slow>
void each_short_run(const Ends& ends, int queue, std::uint64_t needed, Slow slow) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < ends.words.size(); ++i) {
        while (end + 1 < ends.words.size() && ends.words[end + 1] - ends.words[i] <= room(queue)) {
            ++end;
        }
        if (end + 1 == ends.words.size()) return;
        const std::uint64_t ticks = ends.ticks[end] - ends.ticks[i];
        if (ticks < needed) slow(i, end);
    }
}

}  // namespace

double covered_words(const PlanOptions& options) {
    return static_cast<double>(room(options.profile_queue_words));
}

double covered_words(const PlanOptions& options, const Plan& plan) {
    return covered_words(options) / static_cast<double>(needed_ticks(plan));
}

Uncovered uncovered(const Geometry& geometry, const PlanOptions& options, const Plan& plan) {
    const auto share = [needed = needed_ticks(plan)](const Ends& ends, int queue) {
        std::uint64_t known = 0;  // ticks up to which it is counted
        std::uint64_t missing = 0;
        each_short_run(ends, queue, needed, [&](std::size_t first, std::size_t end) {
            missing += ends.ticks[end] - std::max(known, ends.ticks[first]);
            known = ends.ticks[end];
        });
        return static_cast<double>(missing) / static_cast<double>(ends.ticks.back());
    };
    return {share(ends_of_segments(geometry, options), options.segment_queue_words),
            share(ends_of_pieces(plan), options.profile_queue_words)};
}

void drop_uncovered(const PlanOptions& options, Plan& plan) {
    const std::uint64_t needed = needed_ticks(plan);
    const std::size_t most = room(options.profile_queue_words);
    std::vector<PlannedBranch> kept;  // of pieces before `end`
    std::size_t next = 0;             // branch of a piece at `end` or behind it
    std::size_t oldest = 0;           // in `kept`, of a piece that is not before `first`
    std::size_t end = 0;
    std::size_t words = 0;  // words and ticks of the pieces first .. end - 1
    std::uint64_t ticks = 0;
    for (std::size_t first = 0;; ++first) {
        for (;;) {
            const bool branch = next < plan.branches.size() && plan.branches[next].piece == end;
            const std::size_t more =
                kProfileBusWords + (branch ? branch_words(plan.branches[next]) : 0);
            if (end < plan.pieces.size() && (words + more <= most || end == first)) {
                words += more;
                ticks += plan.pieces[end++].ticks;
                if (branch) kept.push_back(std::move(plan.branches[next++]));
            } else if (end == plan.pieces.size()) {
                plan.branches = std::move(kept);
                return;
            } else if (ticks < needed && branch) {
                ++next;
            } else if (ticks < needed && oldest < kept.size()) {
                words -= branch_words(kept.back());
                kept.pop_back();
            } else {
                break;
            }
        }
        words -= kProfileBusWords;
        ticks -= plan.pieces[first].ticks;
        if (oldest < kept.size() && kept[oldest].piece == first) {
            words -= branch_words(kept[oldest++]);
        }
    }
}

std::size_t slow_to_cover(const Geometry& geometry, const PlanOptions& options, const Plan& plan,
                          std::size_t given, int round, std::vector<Slowed>& moves) {
    const Ends segments = ends_of_segments(geometry, options);
    const Ends pieces = ends_of_pieces(plan);
    std::vector<std::uint64_t> ends;  // quanta, ends of planned moves
    std::uint64_t path = 0;
    for (const PlannedMove& move : geometry.moves) ends.push_back(path += move.length);

    const std::uint64_t needed = needed_ticks(plan);
    std::vector<bool> slowed(moves.size(), false);
    const auto each_move = [&](std::uint64_t from, std::uint64_t to, auto slow) {
        const auto first = std::upper_bound(ends.begin(), ends.end(), from) - ends.begin();
        for (auto i = std::max(given, static_cast<std::size_t>(first)); i < ends.size(); ++i) {
            if (slow(moves[i])) slowed[i] = true;
            if (ends[i] >= to) break;
        }
    };
    const double covered = static_cast<double>(needed) / kSlower;
    const auto lower = [&](std::uint64_t from, std::uint64_t to, std::uint64_t ticks) {
        const double length = static_cast<double>(to - from) * kQuantum * plan.unit_mm;
        const double time = (round == 0 ? static_cast<double>(ticks) : covered) * plan.tick_s;
        each_move(from, to, [speed = length / time](Slowed& move) {
            return std::exchange(move.speed, std::min(speed, move.speed)) > speed;
        });
    };
    const double fit = static_cast<double>(room(options.profile_queue_words)) / kProfileBusWords;
    const double ramp = std::ldexp(kRampPieces / fit * covered * plan.tick_s, round / 2);
    const auto lengthen = [&](std::uint64_t from, std::uint64_t to, std::uint64_t /*ticks*/) {
        each_move(from, to, [ramp](Slowed& move) {
            return std::exchange(move.ramp, std::max(ramp, move.ramp)) < ramp;
        });
    };
    const auto each = [needed](const Ends& run, int queue, auto slow) {
        each_short_run(run, queue, needed, [&](std::size_t first, std::size_t end) {
            slow(run.path[first], run.path[end], run.ticks[end] - run.ticks[first]);
        });
    };
    each(segments, options.segment_queue_words, lower);
    if (round % 2 == 0) {
        each(pieces, options.profile_queue_words, lower);
    } else {
        each(pieces, options.profile_queue_words, lengthen);
    }
    return static_cast<std::size_t>(std::count(slowed.begin(), slowed.end(), true));
}

}  // namespace curvecore::ref
