// SPDX-License-Identifier: Apache-2.0
#include "sysc/compare/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/progress_bar.hpp"
#include "sysc/compare/tick_comparison.hpp"

namespace curvecore::sysc {
namespace {

bool same_plan(const CoreParameters& a, const CoreParameters& b) {
    CoreParameters other = b;
    other.anchor = a.anchor;
    for (const ref::Parameter& row : ref::kParameters) {
        if (!row.samples) other.*row.value = a.*row.value;
    }
    return a == other;
}

/// Workers that take group after group of settings; the caller's thread draws the bar.
class Workers {
  public:
    Workers(const Subject& subject, const Segmenter& segmenter,
            const std::vector<CoreParameters>& settings)
        : subject_(subject), segmenter_(segmenter), settings_(settings), rows_(settings.size()) {
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (i == 0 || !same_plan(settings[i - 1], settings[i])) groups_.push_back(i);
        }
        groups_.push_back(settings.size());
    }

    void run(ProgressBar& bar, std::int64_t before) {
        const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
        const auto count = std::min<std::size_t>(processors, groups_.size() - 1);
        std::vector<std::thread> threads;
        working_ = count;
        for (std::size_t i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
        {
            std::unique_lock<std::mutex> lock(mutex_);
            while (!ended_.wait_for(lock, std::chrono::milliseconds(50),
                                    [this] { return working_ == 0; })) {
                bar.update(static_cast<std::uint64_t>(before + done_));
            }
        }
        for (std::thread& thread : threads) thread.join();
        if (failure_) std::rethrow_exception(failure_);
    }

    std::vector<Row> finished() {
        std::vector<Row> rows;
        for (std::optional<Row>& row : rows_) {
            if (row) rows.push_back(std::move(*row));
        }
        return rows;
    }
    bool interrupted() const { return interrupted_; }

  private:
    void work() {
        try {
            std::size_t group = 0;
            while ((group = next_++) + 1 < groups_.size()) compare(groups_[group]);
        } catch (const Interrupted&) {
            interrupted_ = true;
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex_);
            failure_ = std::current_exception();
            next_ = groups_.size();
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        --working_;
        ended_.notify_one();
    }

    void compare(std::size_t first) {
        InterruptGuard::check();
        const SegmentedProgram segmented = segmenter_.segment(settings_[first]);
        for (std::size_t i = first;
             i < settings_.size() && same_plan(settings_[first], settings_[i]); ++i) {
            rows_[i] =
                compare_setting(subject_, settings_[i], segmented, [this](std::int64_t samples) {
                    InterruptGuard::check();
                    done_ += samples;
                });
        }
    }

    const Subject& subject_;
    const Segmenter& segmenter_;
    const std::vector<CoreParameters>& settings_;
    std::vector<std::size_t> groups_;  // first setting of each group, and the end
    std::vector<std::optional<Row>> rows_;
    std::atomic<std::size_t> next_{0};
    std::atomic<std::int64_t> done_{0};
    std::atomic<bool> interrupted_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    std::size_t working_ = 0;
    std::exception_ptr failure_;
};

/// Draws the schemes of --tick on the caller's thread.
void draw_ticked(const Subject& subject, const SweepOptions& options, ProgressBar& bar,
                 SweepResult& result) {
    std::uint64_t ticks = 0;
    const auto progress = [&] {
        if (++ticks % 256 != 0) return;
        InterruptGuard::check();
        bar.update(ticks);
    };
    try {
        for (const TickedSetting& one : options.ticked) {
            result.rows.push_back(compare_ticks(subject, one.setting, one.ticks, progress));
        }
    } catch (const Interrupted&) {
        result.interrupted = true;
    }
}

}  // namespace

SweepResult sweep(const ref::Program& program, const ref::Machine& machine,
                  const std::vector<CoreParameters>& settings, const SweepOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    SweepResult result;
    const Segmenter segmenter(program, machine, options.unit_mm, options.limit,
                              options.times_segments);
    result.reference_segments = segmenter.reference_segments();
    result.most_segments = segmenter.most_segments();
    const auto is_spline = [](const ref::Move& move) {
        return move.kind == ref::Move::Kind::kCubic;
    };
    const auto splines = std::count_if(program.moves.begin(), program.moves.end(), is_spline);
    const auto moves = static_cast<std::ptrdiff_t>(program.moves.size());
    Subject subject{program, options.unit_mm, splines<moves, splines> 0,
                    {},      options.device,  options.by_move};
    const auto all = static_cast<std::int64_t>(settings.size() + 1) * options.samples;
    ProgressBar bar(static_cast<std::uint64_t>(all), options.quiet);
    try {
        subject.exact =
            exact_samples(program, options.unit_mm, options.samples, [&bar](std::int64_t done) {
                InterruptGuard::check();
                bar.update(static_cast<std::uint64_t>(done));
            });
    } catch (const Interrupted&) {
        result.interrupted = true;
        return result;
    }
    Workers workers(subject, segmenter, settings);
    workers.run(bar, options.samples);
    result.rows = workers.finished();
    result.interrupted = workers.interrupted();
    if (!options.ticked.empty() && !result.interrupted) {
        double ticks = 0;
        for (const TickedSetting& one : options.ticked) ticks += ticks_of(program, one.ticks);
        ProgressBar tick_bar(static_cast<std::uint64_t>(ticks), options.quiet);
        draw_ticked(subject, options, tick_bar, result);
    }
    result.samples = static_cast<std::int64_t>(subject.exact.samples.size());
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace curvecore::sysc
