// SPDX-License-Identifier: Apache-2.0
// A program of any length, planned while it is read, in bounded memory.
//
// A window of moves, as many as there is memory for, is planned up to a rest at its end, as if the
// program ended there. The first part of this motion, up to a cut, is given out and stays. The next
// window begins with as much of it as the rule of windows sees, continues from the cut at the same
// speed, and reads more moves. If it cannot continue, what was planned behind the cut is given out
// after all, to its rest.
#pragma once

#include <deque>
#include <exception>
#include <memory>
#include <optional>

#include "ref/feed/stops/part_branches.hpp"
#include "ref/feed/stretch.hpp"
#include "ref/moves/move_source.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {

/// Properties of a program that must be known before its first part.
///
/// | field    | unit | remark                                            |
/// |----------|------|---------------------------------------------------|
/// | file     |      | name for errors                                   |
/// | aux_axes | 1    | in use                                            |
/// | fastest  | mm/s | of its moves, with any override: fastest_motion() |
struct StreamFrame {
    std::string file;
    int aux_axes = 0;
    double fastest = kUnlimitedSpeed;
};

class PlanStream {
  public:
    PlanStream(MoveSource source, StreamFrame frame, Machine machine, const PlanOptions& options);
    ~PlanStream();

    /// Makes the plan of the next part from the moves that follow: its segments and pieces follow
    /// those of the part before, path and moves count from the program's start, and the bounds of
    /// holds are the same. With workers and no horizon the part behind it is planned, too, while
    /// its own branches are found: raise_feed() leaves that part as it is.
    ///
    /// @throws InputError once, in place of a part that cannot be planned: what was given out ends
    ///         at rest before it
    std::optional<Plan> next();

    /// Applies an override above 1 (below 1 the core scales time): the feeds of the moves that no
    /// part has yet become `factor` times those of the program, up to StreamFrame::fastest. The
    /// factor never falls, since a window may have to continue at the speed of the one before.
    void raise_feed(double factor);

    /// Number of windows that could not continue.
    std::size_t forced_stops() const { return forced_stops_; }
    /// Line of the move behind which the first of them stops.
    int forced_stop_line() const { return forced_stop_line_; }

  private:
    struct Window;

    std::optional<PlannedPart> next_part();
    void read(std::size_t size);
    double open_time() const;
    bool is_short(const Window& window);
    void read_next();
    void take_next();
    std::size_t planned_before() const;
    bool take(Move& move);
    void put_back(std::size_t first);
    void check_next();
    void raise(Move& move, double factor) const;
    bool check(const Move& move);
    std::unique_ptr<Window> look(std::size_t most);
    void leave_out_what_fails();
    FeedTask task_of(Window& window) const;
    bool profile(Window& window, const FeedTask& task);
    PlannedPart give_out_whole(Window& window);
    PlannedPart give_out(std::unique_ptr<Window> window);
    PlannedPart stop_where_planned();
    PlannedPart part(Window& window, std::size_t first, std::size_t end);
    void drop(std::size_t first);
    void fail();

    MoveSource source_;
    const Machine machine_;
    const PlanOptions options_;
    const double fastest_;
    double raised_ = 1;
    std::size_t size_;             // moves of a window for which there is memory
    const double horizon_;         // s
    double pace_ = 1;              // time of the last window's open moves over that at their feeds
    std::deque<Move> back_;        // moves read before, to be read again
    Program program_;              // the window's
    std::size_t begun_moves_ = 0;  // moves of it that a part has, or the start of
    std::size_t dropped_ = 0;      // moves of the whole program before it
    double miss_ = 0;              // quanta of path before it, PlannedMove::miss
    std::vector<Move> next_;       // moves that follow it, up to one that has a length
    bool more_ = true;             // such a move exists
    std::vector<GivenRun> given_;
    std::unique_ptr<Window> before_;   // the last window, for what lies behind its cut
    std::optional<PlannedPart> held_;  // a part that is not yet given
    std::exception_ptr behind_;        // the error behind it
    bool begun_ = false;
    bool ended_ = false;
    std::exception_ptr error_;
    Plan frame_;              // data that all parts have
    std::uint64_t path_ = 0;  // quanta given out
    std::size_t forced_stops_ = 0;
    int forced_stop_line_ = 0;
};

}  // namespace curvecore::ref
