// SPDX-License-Identifier: Apache-2.0
// Source of a program's words, planned by a separate thread while they are sent.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sysc/board/board.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/link/link.hpp"
#include "sysc/panel/planned_path.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::sysc {

/// A wait of the program, behind so many words from the program's start.
struct WaitWord {
    std::uint64_t segments = 0;
    std::uint64_t pieces = 0;
    ref::PlannedWait wait;
};

/// Words that are planned so far.
struct PlannedWords {
    std::deque<std::uint64_t> segments;
    std::deque<std::uint64_t> pieces;
    std::deque<WaitWord> waits;
    std::uint64_t words = 0;
    std::uint64_t samples = 0;
    std::uint64_t path = 0;     // quanta
    std::uint64_t busiest = 0;  // greatest number of words in a second of the program
    bool all = false;
};

/// The part of a program that was drawn and sent before its rest, which options.from_mm cuts off.
struct DrawnBefore {
    std::uint64_t path = 0;  // quanta
    std::uint64_t words = 0;
    std::uint64_t samples = 0;
};

/// Places, lengths and sums count from the program's start, whatever was drawn before.
class WordSource {
  public:
    /// @throws ref::InputError, UsageError, as JobStream does
    explicit WordSource(const Options& options) : WordSource(options, machine_of(options)) {}
    WordSource(const Options& options, const ref::Machine& machine, const DrawnBefore& before = {});
    ~WordSource();
    WordSource(const WordSource&) = delete;
    WordSource& operator=(const WordSource&) = delete;

    /// Waits for the first part and returns the settings of the board.
    BoardSettings settings();
    /// Start of the program, mm; to be called after settings().
    const std::array<double, kBoardAxes>& start() const { return start_; }
    /// Returns the first line at which the program waits for a person, as far as it was looked at;
    /// 0: none. To be called after settings().
    int first_wait() const { return stream_->job().first_wait; }
    /// Returns the path, as far as it is planned.
    PlannedPath& path() { return path_; }
    /// Notes the path that is drawn, quanta, and whether the axes move: plans as far ahead as the
    /// board needs.
    void follow(std::uint64_t path, bool moves);
    /// Returns what is behind when so much of the path is drawn, and so many words are sent.
    DrawnBefore drawn(std::uint64_t path, std::uint64_t words);
    /// Raises the feeds of what is not planned yet: from there on the override is at least so many
    /// percent.
    void raise(double percent);
    /// Returns the greatest ratio of planned feeds to those of the program.
    double raised();
    /// Adds the new words to those held and updates the figures of planning. If none are held
    /// while the board needs another part, waits for it, so long at most.
    /// @throws the error that ended the planning, once its words are taken
    void take(PlannedWords& held, WireClock::duration wait = {});
    /// Returns the options as planning has completed them. To be called after settings().
    const Options& options() const { return stream_->job().options; }
    /// Returns the warnings, once take() reports that all is planned.
    const std::vector<std::string>& warnings() const { return stream_->job().program.warnings; }

  private:
    void fill();
    bool is_due();
    void add(const ref::Plan& part);
    void count_words(std::size_t words);
    void pass(double time_s);

    DrawnBefore before_;
    std::optional<JobStream> stream_;
    std::mutex mutex_;
    std::condition_variable changed_;
    PlannedWords planned_;
    PlannedPath path_;
    std::optional<SegmentWriter> segment_words_;
    std::optional<ProfileWriter> piece_words_;
    double time_s_ = 0;  // planned time of the program
    std::uint64_t segment_word_count_ = 0;
    std::uint64_t piece_word_count_ = 0;
    std::uint64_t words_of_second_ = 0;
    std::uint64_t busiest_ = 0;
    std::optional<BoardSettings> settings_;
    std::array<double, kBoardAxes> start_{};
    std::exception_ptr failed_;
    std::uint64_t drawn_ = 0;   // quanta
    bool moves_ = false;        // the axes do
    double stop_s_ = 0;         // motion that a stop takes
    double planning_s_ = 0;     // time that a part takes to be planned
    double asked_percent_ = 0;  // override
    double raised_ = 1;
    bool stop_ = false;
    std::thread thread_;  // last member: it uses the others
};

}  // namespace curvecore::sysc
