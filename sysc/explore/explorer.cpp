// SPDX-License-Identifier: Apache-2.0
#include "sysc/explore/explorer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sysc/board/feeder.hpp"
#include "sysc/board/kernel_board.hpp"
#include "sysc/system/system_board.hpp"
#include "sysc/words/path_source.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kSlower = 1.01;

/// Draws the job to its end, or to the first hold.
Fate draw_job(const Job& job, std::uint64_t samples) {
    const Options& options = job.options;
    const QueueDepths depths{options.segment_queue_words, options.profile_queue_words};
    const std::unique_ptr<Board> board = make_system_board(
        job, std::make_unique<KernelBoard>(options.core, board_settings(job), depths), nullptr);
    Feeder feeder(job, samples, *board);
    std::vector<Sample> batch;
    // By then the host has filled the queues, requested the first sample and received it.
    const double beginning = 3 + std::ceil(options.sample_period_s / options.system.host_s);
    bool begun = false;
    for (double turn = 0; !feeder.done(); ++turn) {
        batch.clear();
        feeder.turn(batch);
        begun = begun || !batch.empty();
        if (!begun && turn > beginning) return Fate::kNeverBegins;
        if (board->status().starved > 0) return Fate::kHolds;
    }
    return Fate::kFits;
}

double stop_of(const DrawnPlan& plan) {
    const std::uint64_t ticks = plan.branches == 0 ? plan.stop_ticks : plan.longest_stop;
    return static_cast<double>(ticks) * plan.tick_s;
}

}  // namespace

Explorer::Explorer(const Options& options, const ExploreGrid& grid,
                   std::function<void(double share)> progress)
    : options_(options), grid_(grid), progress_(std::move(progress)) {}

std::optional<ExplorePoint> ExploreRow::answer() const {
    std::optional<ExplorePoint> best;
    const auto words = [](const ExplorePoint& point) {
        return point.segment_queue + point.profile_queue;
    };
    for (const ExplorePoint& point : points) {
        if (point.fate == Fate::kFits && (!best || words(point) < words(*best))) best = point;
    }
    return best;
}

std::vector<ExploreRow> Explorer::explore() {
    std::vector<ExploreRow> all;
    for (const double sample_s : grid_.sample_s) {
        const std::vector<ExploreRow> rows = explore_period(sample_s);
        all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
}

std::vector<ExploreRow> Explorer::explore_period(double sample_s) {
    std::vector<ExploreRow> rows;
    for (const double word_s : grid_.word_s) {
        for (const double host_s : grid_.host_s) rows.push_back({{sample_s, word_s, host_s}, {}});
    }
    for (auto segments = grid_.segment_queue.rbegin(); segments != grid_.segment_queue.rend();
         ++segments) {
        for (auto profile = grid_.profile_queue.rbegin(); profile != grid_.profile_queue.rend();
             ++profile) {
            explore_queues(*segments, *profile, rows);
        }
    }
    return rows;
}

void Explorer::explore_queues(int segment_queue, int profile_queue, std::vector<ExploreRow>& rows) {
    Options planned = options_;
    planned.sample_period_s = rows.front().surroundings.sample_s;
    planned.segment_queue_words = segment_queue;
    planned.profile_queue_words = profile_queue;
    Job job = plan_job(planned);
    Options& options = job.options;
    const std::uint64_t samples =
        count_samples(job.plan, options.samples_per_tick_log2(), options.override_word());
    const double duration = static_cast<double>(samples) * options.sample_period_s;
    for (ExploreRow& row : rows) {
        ExplorePoint point{segment_queue, profile_queue, Fate::kSlows, duration, stop_of(job.plan)};
        const bool slows =
            !row.points.empty() && duration > kSlower * row.points.front().duration_s;
        if (!slows) {
            options.system.host_s = row.surroundings.host_s;
            options.system.word_s = row.surroundings.word_s;
            point.fate = draw_job(job, samples);
        }
        row.points.push_back(point);
        done_ += 1 / static_cast<double>(grid_.size());
        progress_(done_);
    }
}

}  // namespace curvecore::sysc
