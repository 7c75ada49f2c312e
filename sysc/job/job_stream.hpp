// SPDX-License-Identifier: Apache-2.0
// A job of any length, planned part by part while its program is read.
#pragma once

#include <functional>

#include "ref/feed/plan_stream.hpp"
#include "ref/limits/move_parts.hpp"
#include "ref/moves/moves_ahead.hpp"
#include "ref/outputs/placed_outputs.hpp"
#include "ref/outputs/placed_waits.hpp"
#include "sysc/job/drawn_moves.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

class JobStream {
  public:
    /// Checks a file, move by move: blocks, travel and segments. If the core or the machine cannot
    /// draw the smooth path, the program is drawn as written. The first moves of standard input
    /// define the core.
    /// @param form of its splines; none: the one that core and options choose
    /// @throws ref::InputError
    explicit JobStream(const Options& options, std::optional<ref::SplineForm> form = {});
    /// Creates a job for another machine than that of the options.
    JobStream(const Options& options, ref::Machine machine,
              std::optional<ref::SplineForm> form = {});

    /// Returns what all parts of the job share; with warnings at the end.
    const Job& job() const { return job_; }
    /// Returns the number of moves drawn so far.
    std::size_t moves() const { return given_; }
    /// Returns the options; the core is fixed, others may be changed before the first part.
    Options& options() { return job_.options; }

    /// Raises the feeds of what follows the next part's begin, with options.live: from here on the
    /// override is at least so many percent.
    void raise(double percent);

    /// Plans the next part; null: there is none.
    /// @throws UsageError: a sample period shorter than the core's own clocks
    /// @throws ref::InputError of moves not checked before, after all parts up to a rest before
    /// them
    const ref::Plan* next();

    using LookAtPart = std::function<void(const Job& job, const ref::Plan& part)>;
    /// Plans the whole job; to be called before the first part is requested.
    /// @throws what next() and `look` do
    Job all(const LookAtPart& look = {});

  private:
    struct Seen;

    void look_at_program();
    std::optional<int> first_drawn_spline(std::optional<int> programmed) const;
    void look_at_drawn();
    void look_at_input();
    void use(const Seen& seen);
    void begin();
    void end();
    void draw_as_programmed();
    void watch(const ref::Plan& part, ref::LimitWatch& limits) const;
    bool read(DrawnMoves& moves, ref::Move& move) const;
    bool take(ref::Move& move);
    bool take_next(ref::Move& move);
    void read_ahead(const std::shared_ptr<ref::Workers>& workers);
    const ref::Events& events() const;

    std::optional<ref::SplineForm> form_;
    Job job_;
    std::optional<DrawnMoves> moves_;
    std::optional<ref::MovesAhead> ahead_;  // of these, with several threads
    std::optional<ref::MoveParts> parts_;
    std::vector<ref::Move> first_;  // first moves of standard input, which were checked
    std::size_t taken_ = 0;         // number of these that were taken
    bool splines_ = false;
    double fastest_ = 0;
    std::optional<ref::PlacedOutputs> outputs_;
    ref::PlacedWaits waits_;
    std::optional<ref::PlanStream> plan_;
    std::optional<ref::Plan> part_;
    std::size_t given_ = 0;  // number of moves given
    bool keeps_ = false;     // parts are kept in the job's plan
    double duration_s_ = 0;  // duration of the parts
    bool bounded_ = true;
};

}  // namespace curvecore::sysc
