// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/word_source.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "sysc/board/feeder.hpp"

namespace curvecore::sysc {
namespace {

/// Greatest number of words that wait for the link; planning then waits.
constexpr std::size_t kMostWords = 200'000;
// Motion that is left when the next part is planned: what a stop takes, and this besides.
constexpr double kSpare_s = 0.3;
constexpr double kPlannings = 3;  // times of planning a part
constexpr double kForgets = 0.9;  // share of the longest of these that the next part leaves

void append(std::deque<std::uint64_t>& all, const std::vector<std::uint64_t>& words) {
    all.insert(all.end(), words.begin(), words.end());
}

/// Start point of a program, mm.
std::array<double, kBoardAxes> start_of(const ref::Segment& first, double unit_mm) {
    std::array<double, kBoardAxes> start{};
    for (std::size_t axis = 0; axis < kBoardAxes; ++axis) {
        const double units =
            axis < 3 ? first.start[static_cast<int>(axis)] : first.aux_start[axis - 3];
        start[axis] = units * unit_mm;
    }
    return start;
}

template <class Item>
void move_to(std::deque<Item>& held, std::deque<Item>& planned) {
    held.insert(held.end(), planned.begin(), planned.end());
    planned.clear();
}

}  // namespace

WordSource::WordSource(const Options& options, const ref::Machine& machine,
                       const DrawnBefore& before)
    : before_(before), path_(machine, before.path), drawn_(before.path) {
    stream_.emplace(options, machine);
    planned_.path = before.path;
    planned_.words = before.words;
    planned_.samples = before.samples;
    thread_ = std::thread([this] { fill(); });
}

WordSource::~WordSource() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void WordSource::fill() {
    try {
        double percent = std::max(100.0, stream_->job().options.override_percent);
        for (;;) {
            const auto begin = std::chrono::steady_clock::now();
            const ref::Plan* part = stream_->next();
            if (part == nullptr) break;
            add(*part);
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
            std::unique_lock lock(mutex_);
            raised_ = percent / 100;
            planning_s_ = std::max(took.count(), kForgets * planning_s_);
            changed_.wait(lock, [this] { return stop_ || is_due(); });
            if (stop_) return;
            if (asked_percent_ <= percent) continue;
            percent = asked_percent_;
            lock.unlock();
            stream_->raise(percent);
        }
    } catch (...) {
        failed_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    planned_.all = true;
    changed_.notify_all();
}

/// Returns true if another part is needed: what is planned and not drawn has to last for a stop, to
/// begin for two, and until more is planned.
bool WordSource::is_due() {
    if (planned_.segments.size() + planned_.pieces.size() >= kMostWords) return false;
    const double ahead = path_.time_s() - path_.at(drawn_).time_s;
    return ahead < (moves_ ? 1 : 2) * stop_s_ + kSpare_s + kPlannings * planning_s_;
}

void WordSource::follow(std::uint64_t path, bool moves) {
    const std::lock_guard lock(mutex_);
    drawn_ = path;
    moves_ = moves;
    path_.pass(path);
    changed_.notify_all();
}

DrawnBefore WordSource::drawn(std::uint64_t path, std::uint64_t words) {
    const double samples = path_.at(path).time_s / stream_->job().options.sample_period_s;
    return {path, words, before_.samples + static_cast<std::uint64_t>(std::llround(samples))};
}

double WordSource::raised() {
    const std::lock_guard lock(mutex_);
    return raised_;
}

void WordSource::raise(double percent) {
    const std::lock_guard lock(mutex_);
    asked_percent_ = percent;
}

void WordSource::add(const ref::Plan& part) {
    path_.add(part);
    const Options& options = stream_->job().options;
    PlannedWords words;
    if (!segment_words_) {
        const std::uint16_t digest = stream_->job().digest();
        segment_words_.emplace(options.core, digest);
        piece_words_ = profile_writer(stream_->job());
    }
    const double tick_s = options.sample_period_s * options.samples_per_tick;
    std::size_t next = 0;  // next segment to count
    double segment_s = 0;  // begin of that segment, relative to the part
    double piece_s = 0;
    for (const ref::Segment& segment : part.segments) {
        append(words.segments, segment_words_->write(segment));
    }
    const std::size_t each = words.segments.size() / std::max<std::size_t>(part.segments.size(), 1);
    std::size_t wait = 0;
    for (std::size_t i = 0; i < part.pieces.size(); ++i) {
        for (; wait < part.waits.size() && part.waits[wait].pieces == i; ++wait) {
            append(words.pieces, piece_words_->wait(part));
            words.waits.push_back({segment_word_count_ + each * part.waits[wait].segments,
                                   piece_word_count_ + words.pieces.size(), part.waits[wait]});
            words.waits.back().wait.place += before_.path;
        }
        const std::vector<std::uint64_t> piece = piece_words_->write(part, i);
        append(words.pieces, piece);
        for (; next < part.segments.size() && segment_s <= piece_s; ++next) {
            segment_s += part.segments[next].ticks * tick_s;
            count_words(each);
        }
        count_words(piece.size());
        piece_s += part.pieces[i].ticks * tick_s;
        pass(part.pieces[i].ticks * tick_s);
    }
    segment_word_count_ += words.segments.size();
    piece_word_count_ += words.pieces.size();
    const auto ticks = static_cast<std::uint64_t>(ref::ticks_of(part.pieces));
    const std::lock_guard lock(mutex_);
    planned_.words += words.segments.size() + words.pieces.size();
    planned_.samples += ticks << options.samples_per_tick_log2();
    planned_.path = before_.path + part.segments.back().s_start + part.segments.back().length;
    planned_.busiest = busiest_;
    stop_s_ = part.stop_ticks * part.tick_s;
    move_to(planned_.segments, words.segments);
    move_to(planned_.pieces, words.pieces);
    move_to(planned_.waits, words.waits);
    if (!settings_) {
        settings_ = board_settings(stream_->job());
        start_ = start_of(part.segments.front(), options.unit_mm);
    }
    changed_.notify_all();
}

void WordSource::count_words(std::size_t words) {
    words_of_second_ += words;
    busiest_ = std::max(busiest_, words_of_second_);
}

void WordSource::pass(double time_s) {
    const double second = std::floor(time_s_);
    time_s_ += time_s;
    if (std::floor(time_s_) != second) words_of_second_ = 0;
}

BoardSettings WordSource::settings() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return settings_ || planned_.all; });
    if (!settings_) std::rethrow_exception(failed_);
    return *settings_;
}

void WordSource::take(PlannedWords& held, WireClock::duration wait) {
    std::unique_lock lock(mutex_);
    if (held.segments.empty() && held.pieces.empty()) {
        changed_.wait_for(lock, wait,
                          [this] { return planned_.all || !planned_.pieces.empty() || !is_due(); });
    }
    move_to(held.segments, planned_.segments);
    move_to(held.pieces, planned_.pieces);
    move_to(held.waits, planned_.waits);
    held.words = planned_.words;
    held.samples = planned_.samples;
    held.path = planned_.path;
    held.busiest = planned_.busiest;
    held.all = planned_.all;
    changed_.notify_all();
    if (planned_.all && failed_ && held.segments.empty() && held.pieces.empty()) {
        std::rethrow_exception(failed_);
    }
}

}  // namespace curvecore::sysc
