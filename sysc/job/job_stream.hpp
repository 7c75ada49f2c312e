// SPDX-License-Identifier: Apache-2.0
// A job of any length, planned part by part while its program is read.
#pragma once

#include <functional>

#include "ref/feed/plan_stream.hpp"
#include "ref/limits/move_parts.hpp"
#include "sysc/job/drawn_moves.hpp"
#include "sysc/job/job.hpp"

namespace curvecore::sysc {

class JobStream {
  public:
    /// Looks at a file, move by move: blocks, travel and segments. Where the core or the machine
    /// cannot have the smooth path it is drawn as programmed. Of standard input the first moves say
    /// what the core must have.
    /// @param form of its splines; none: as core and options want them
    /// @throws ref::InputError
    explicit JobStream(const Options& options, std::optional<ref::SplineForm> form = {});
    /// For another machine than that of the options.
    JobStream(const Options& options, ref::Machine machine,
              std::optional<ref::SplineForm> form = {});

    /// Of its plan what all parts have; with warnings at the end.
    const Job& job() const { return job_; }
    /// Moves that are drawn, so far.
    std::size_t moves() const { return given_; }
    /// The core is known; what else there is may be changed before the first part.
    Options& options() { return job_.options; }

    /// The plan of the next part; null: there is none.
    /// @throws UsageError: a sample period shorter than the core's own clocks
    /// @throws ref::InputError of what was not looked at, after all parts up to a rest before it
    const ref::Plan* next();

    using LookAtPart = std::function<void(const Job& job, const ref::Plan& part)>;
    /// All of the job, before its first part was asked for.
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

    std::optional<ref::SplineForm> form_;
    Job job_;
    std::optional<DrawnMoves> moves_;
    ref::MoveParts parts_{[this](ref::Move& move) { return take_next(move); }, job_.machine};
    std::vector<ref::Move> first_;  // of standard input, that were looked at
    std::size_t taken_ = 0;         // of these
    bool splines_ = false;
    double fastest_ = 0;
    std::optional<ref::PlanStream> plan_;
    std::optional<ref::Plan> part_;
    std::size_t given_ = 0;  // moves
    bool keeps_ = false;     // in the job's plan
    double duration_s_ = 0;  // of the parts
    bool bounded_ = true;
};

}  // namespace curvecore::sysc
