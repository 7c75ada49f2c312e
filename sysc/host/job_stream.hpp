// SPDX-License-Identifier: Apache-2.0
// A job of any length, planned part by part while its program is read.
#pragma once

#include "ref/feed/plan_stream.hpp"
#include "sysc/host/drawn_moves.hpp"
#include "sysc/host/job.hpp"

namespace curvecore::sysc {

class JobStream {
  public:
    /// Looks at a file, move by move: blocks, travel and segments. Where the core or the machine
    /// cannot have the smooth path it is drawn as programmed. Of standard input the first moves say
    /// what the core must have.
    /// @throws ref::InputError
    explicit JobStream(const Options& options);

    /// Without moves; with warnings at the end.
    const Job& job() const { return job_; }
    /// The core is known; what else there is may be changed before the first part.
    Options& options() { return job_.options; }

    /// The job with the plan of the next part; null: there is none.
    /// @throws UsageError: a sample period shorter than the core's own clocks
    /// @throws ref::InputError of what was not looked at, after all parts up to a rest before it
    const Job* next();

  private:
    struct Seen;

    void look_at_program();
    std::optional<int> first_drawn_spline() const;
    void look_at_drawn();
    void look_at_input();
    void use(const Seen& seen);
    bool read(DrawnMoves& moves, ref::Move& move) const;
    bool take(ref::Move& move);

    Job job_;
    std::optional<DrawnMoves> moves_;
    std::vector<ref::Move> first_;  // of standard input, that were looked at
    std::size_t taken_ = 0;         // of these
    bool splines_ = false;
    double fastest_ = 0;
    std::optional<ref::PlanStream> plan_;
    std::size_t slowed_ = 0;
    bool bounded_ = true;
};

}  // namespace curvecore::sysc
