// SPDX-License-Identifier: Apache-2.0
#include "sysc/host/job_stream.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/program/input_error.hpp"
#include "ref/segment/geometry.hpp"
#include "sysc/host/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

constexpr std::size_t kBatch = 500;  // moves whose segments are looked at together

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
        look_at_file();
    } catch (const ref::InputError&) {
        if (job_.options.exact_path) throw;
        job_.options = options;
        job_.options.exact_path = true;
        look_at_file();
        warn_of_exact_path(job_);
    }
    moves_.emplace(job_.options, job_.machine);
}

/// With the feed that an override above 100 % asks for.
bool JobStream::read(DrawnMoves& moves, ref::Move& move) const {
    if (!moves.next(move)) return false;
    raise_feed(move, job_.options);
    return true;
}

/// In constant memory.
void JobStream::look_at_file() {
    DrawnMoves moves(job_.options, job_.machine);
    job_.program.file = moves.program().file();
    ref::PlanOptions options = job_.options.plan_options();
    options.aux_axes = ref::kAuxAxes;
    if (draws_splines(job_.options)) options.format.splines = 1;
    Seen seen;
    ref::Program batch = job_.program;
    const auto look = [&] {
        ref::make_geometry(batch, job_.machine, options);
        batch.moves.clear();
    };
    for (ref::Move move; read(moves, move);) {
        seen.add(move);
        batch.moves.push_back(move);
        if (batch.moves.size() == kBatch) look();
    }
    look();
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
