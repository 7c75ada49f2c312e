// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/job_stream.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/program/input_error.hpp"
#include "ref/segment/geometry.hpp"
#include "sysc/host/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

/// Travel and segments of moves, some at a time.
class Looker {
  public:
    explicit Looker(const Job& job)
        : machine_(job.machine), options_(segment_options(job.options)) {
        batch_.file = job.program.file;
    }

    /// @throws ref::InputError, of one of the last moves
    void add(const ref::Move& move) {
        constexpr std::size_t kBatch = 500;
        batch_.moves.push_back(move);
        if (batch_.moves.size() == kBatch) look();
    }
    void look() {
        ref::make_geometry(batch_, machine_, options_);
        batch_.moves.clear();
    }

  private:
    const ref::Machine& machine_;
    ref::PlanOptions options_;
    ref::Program batch_;
};

int aux_axes_of(const ref::Move& move) {
    int axes = 0;
    for (int i = 0; i < ref::kAuxAxes; ++i) {
        if (move.aux_end[i] != move.aux_start[i]) axes = i + 1;
    }
    return axes;
}

bool is_spline(const ref::Move& move) { return move.kind == ref::Move::Kind::kCubic; }

}  // namespace

/// What a program, or its first moves, ask of the core.
struct JobStream::Seen {
    int aux_axes = 0;
    std::optional<int> spline;  // line of the first
    double fastest = 0;         // mm/s

    void add(const ref::Move& move) {
        aux_axes = std::max(aux_axes, aux_axes_of(move));
        if (is_spline(move) && !spline) spline = move.line;
        fastest = std::max(fastest, ref::fastest_motion(move));
    }
};

JobStream::JobStream(const Options& options) {
    job_.options = options;
    if (!options.machine.empty()) job_.machine = ref::read_machine(options.machine);
    if (options.file == ref::kStandardInput) {
        look_at_input();
        return;
    }
    try {
        look_at_program();
    } catch (const ref::InputError&) {  // what is drawn may still do
        look_at_drawn();
    }
    moves_.emplace(job_.options, job_.machine);
}

/// With the feed that an override above 100 % asks for.
bool JobStream::read(DrawnMoves& moves, ref::Move& move) const {
    if (!moves.next(move)) return false;
    raise_feed(move, job_.options);
    return true;
}

/// In constant memory: what it draws is looked at again while it is drawn.
void JobStream::look_at_program() {
    ref::ProgramStream program(job_.options.file, job_.options.points, job_.options.open_program);
    job_.program.file = program.file();
    Seen seen;
    Looker looker(job_);
    for (ref::Move move; program.next(move);) {
        raise_feed(move, job_.options);
        seen.add(move);
        looker.add(move);
    }
    looker.look();
    seen.spline = first_drawn_spline();
    use(seen);
}

/// A core draws all splines or none of them.
std::optional<int> JobStream::first_drawn_spline() const {
    if (draws_arcs(job_.options)) return {};
    DrawnMoves moves(job_.options, job_.machine);
    for (ref::Move move; moves.next(move);) {
        if (is_spline(move)) return move.line;
    }
    return {};
}

void JobStream::look_at_drawn() {
    DrawnMoves moves(job_.options, job_.machine);
    job_.program.file = moves.program().file();
    Seen seen;
    Looker looker(job_);
    for (ref::Move move; read(moves, move);) {
        seen.add(move);
        looker.add(move);
    }
    looker.look();
    use(seen);
}

/// As far as the first window of the plan.
void JobStream::look_at_input() {
    moves_.emplace(job_.options, job_.machine);
    job_.program.file = moves_->program().file();
    Seen seen;
    bool more = true;
    for (ref::Move move; first_.size() < job_.options.plan_options().window;) {
        more = read(*moves_, move);
        if (!more) break;
        first_.push_back(move);
        seen.add(move);
    }
    if (more) seen.fastest = 1e9;
    use(seen);
}

void JobStream::use(const Seen& seen) {
    set_splines(job_, seen.spline);
    if (!job_.options.aux_axes_set) job_.options.core.aux_axes = seen.aux_axes;
    job_.program.aux_axes = seen.aux_axes;
    fastest_ = seen.fastest;
    splines_ = seen.spline.has_value();
}

/// Of standard input the first moves have said what the core has.
bool JobStream::take(ref::Move& move) {
    if (taken_ < first_.size()) {
        move = first_[taken_++];
        return true;
    }
    if (!read(*moves_, move)) return false;
    if (aux_axes_of(move) > job_.program.aux_axes) {
        throw ref::InputError(
            job_.program.file, move.line,
            "an axis that the first moves of this stream do not use: read a file");
    }
    if (is_spline(move) && job_.options.core.splines == 0) {
        throw ref::InputError(job_.program.file, move.line,
                              "a spline, and the first moves of this stream have none: give "
                              "--set Splines=1");
    }
    return true;
}

const Job* JobStream::next() {
    if (!plan_) {
        const Options& options = job_.options;
        check_period(options.core, splines_, options.sample_period_s, options.clock_hz,
                     options.samples_per_tick);
        plan_.emplace([this](ref::Move& move) { return take(move); },
                      ref::StreamFrame{job_.program.file, job_.program.aux_axes, fastest_},
                      job_.machine, options.plan_options());
    }
    std::optional<ref::Plan> part = plan_->next();
    if (!part) {
        const std::vector<std::string>& read = moves_->program().warnings();
        std::vector<std::string>& warnings = job_.program.warnings;
        warnings.insert(warnings.begin(), read.begin(), read.end());
        if (moves_->refused()) warn_of_exact_path(job_);
        job_.plan.slowed_moves = slowed_;
        warn_of_plan(job_, bounded_);
        return nullptr;
    }
    slowed_ += part->slowed_moves;
    job_.plan = std::move(*part);
    bounded_ = bounded_ && job_.bounded();
    return &job_;
}

}  // namespace curvecore::sysc
