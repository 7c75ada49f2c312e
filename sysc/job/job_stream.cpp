// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/job_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "ref/geometry/segment_batches.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/core/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

/// Batches of a program's moves, as they are read.
ref::SegmentBatches batches(const Job& job) {
    return {job.program.file, job.machine, segment_options(job.options)};
}

int aux_axes_of(const ref::Move& move) {
    int axes = 0;
    for (int i = 0; i < ref::kAuxAxes; ++i) {
        if (move.aux_end[i] != move.aux_start[i]) axes = i + 1;
    }
    return axes;
}

constexpr double kLivePart = 0.5;  // s, least time of a part of a move
/// Moves that another thread reads ahead: with those of most windows fewer than KnownCuts keeps.
constexpr std::size_t kAhead = 2000;

bool is_spline(const ref::Move& move) { return move.kind == ref::Move::Kind::kCubic; }

}  // namespace

/// Demands that a program, or its first moves, put on the core.
struct JobStream::Seen {
    int aux_axes = 0;
    std::optional<int> spline;  // line of the first spline
    double fastest = 0;         // mm/s

    void add(const ref::Move& move) {
        aux_axes = std::max(aux_axes, aux_axes_of(move));
        if (is_spline(move) && !spline) spline = move.line;
        fastest = std::max(fastest, ref::fastest_motion(move));
    }
};

JobStream::JobStream(const Options& options, std::optional<ref::SplineForm> form)
    : JobStream(options, machine_of(options), form) {}

JobStream::JobStream(const Options& options, ref::Machine machine,
                     std::optional<ref::SplineForm> form)
    : form_(form) {
    job_.options = options;
    job_.machine = std::move(machine);
    if (!options.program && options.file == ref::kStandardInput) {
        look_at_input();
        return;
    }
    const bool joints = job_.joints();  // what they draw is known of the drawn path alone
    try {
        joints ? look_at_drawn() : look_at_program();
    } catch (const ref::InputError&) {
        if (joints) throw;
        const std::exception_ptr programmed = std::current_exception();
        try {
            look_at_drawn();  // it may still draw as programmed
        } catch (const ref::InputError&) {
            std::rethrow_exception(programmed);
        }
    }
    moves_.emplace(job_.options, job_.machine, form_);
}

/// Reads a move, with the feed raised for an override above 100 %.
bool JobStream::read(DrawnMoves& moves, ref::Move& move) const {
    if (!moves.next(move)) return false;
    raise_feed(move, job_.options);
    return true;
}

/// Checks the whole program in constant memory: it is checked again while it is drawn.
void JobStream::look_at_program() {
    ref::ProgramStream program = open_program(job_.options);
    job_.program.file = program.file();
    Seen seen;
    ref::SegmentBatches looker = batches(job_);
    double length = 0;
    for (ref::Move move; program.next(move);) {
        raise_feed(move, job_.options);
        seen.add(move);
        looker.add(move);
        length = move.to;
    }
    looker.look();
    job_.first_wait = ref::first_wait(program.events(), length);
    seen.spline = first_drawn_spline(seen.spline);
    use(seen);
}

/// Line of the first spline that is drawn: a core draws all splines or none of them.
std::optional<int> JobStream::first_drawn_spline(std::optional<int> programmed) const {
    const bool splines = form_of(job_.options, form_) == ref::SplineForm::kSpline;
    if (!splines && job_.options.arc_tolerance) return {};
    if (!splines || job_.options.exact_path) return programmed;
    DrawnMoves moves(job_.options, job_.machine, form_);
    for (ref::Move move; moves.next(move);) {
        if (is_spline(move)) return move.line;
    }
    return {};
}

void JobStream::look_at_drawn() {
    DrawnMoves moves(job_.options, job_.machine, form_);
    job_.program.file = moves.program().file();
    Seen seen;
    ref::SegmentBatches looker = batches(job_);
    double length = 0;
    for (ref::Move move; read(moves, move);) {
        seen.add(move);
        looker.add(move);
        length = move.to;
    }
    looker.look();
    job_.first_wait = ref::first_wait(moves.program().events(), length);
    use(seen);
}

/// Checks standard input up to the first window of the plan.
void JobStream::look_at_input() {
    moves_.emplace(job_.options, job_.machine, form_);
    job_.program.file = moves_->program().file();
    Seen seen;
    bool more = true;
    for (ref::Move move; first_.size() < job_.options.plan_options().window;) {
        more = read(*moves_, move);
        if (!more) break;
        first_.push_back(move);
        seen.add(move);
    }
    if (more) seen.fastest = ref::kUnlimitedSpeed;
    use(seen);
}

void JobStream::use(const Seen& seen) {
    set_splines(job_, seen.spline);
    if (!job_.options.aux_axes_set) job_.options.core.aux_axes = seen.aux_axes;
    job_.program.aux_axes = seen.aux_axes;
    fastest_ = seen.fastest;
    splines_ = seen.spline.has_value();
}

bool JobStream::take(ref::Move& move) {
    if (!parts_->next(move)) return false;
    ++given_;
    outputs_->add(move, events());
    waits_.add(move, events());
    if (keeps_) job_.plan.moves.push_back(move);
    return true;
}

/// Takes a move; the first moves of standard input were read to configure the core.
bool JobStream::take_next(ref::Move& move) {
    if (taken_ < first_.size()) {
        move = first_[taken_++];
        return true;
    }
    if (!(ahead_ ? ahead_->next(move) : read(*moves_, move))) return false;
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

void JobStream::raise(double percent) {
    if (!plan_) begin();
    plan_->raise_feed(percent / 100 / job_.options.feed_factor());
}

const ref::Plan* JobStream::next() {
    if (!plan_) begin();
    part_ = plan_->next();
    if (!part_) {
        end();
        return nullptr;
    }
    if (part_->segments.back().last) outputs_->end(events());
    outputs_->place(*part_);
    waits_.place(*part_);
    static_cast<ref::PlanFrame&>(job_.plan) = *part_;
    duration_s_ += part_->duration_s;
    job_.plan.slowed_moves += part_->slowed_moves;
    if (job_.plan.slowed_line == 0) job_.plan.slowed_line = part_->slowed_line;
    job_.plan.core_slowed.add(part_->core_slowed);
    bounded_ =
        bounded_ && std::all_of(part_->segments.begin(), part_->segments.end(),
                                [this](const ref::Segment& s) { return job_.bounded(s.kind()); });
    return &*part_;
}

void JobStream::begin() {
    const auto check = [this] {
        const Options& options = job_.options;
        check_period(options.core, splines_, options.sample_period_s, options.clock_hz,
                     options.samples_per_tick);
    };
    try {
        check();
    } catch (const UsageError&) {
        if (!splines_ || job_.options.exact_path || first_.size() > 0) throw;
        draw_as_programmed();
        check();
    }
    ref::PlanOptions options = job_.options.plan_options();
    options.cuts = moves_->cuts();
    if (job_.options.threads > 1) {
        options.workers = std::make_shared<ref::Workers>(job_.options.threads);
        read_ahead(options.workers);
    }
    const bool live = job_.options.live;
    parts_.emplace([this](ref::Move& move) { return take_next(move); }, job_.machine,
                   live ? kLivePart : ref::kLongestPart);
    // Bounds of holds are those of the fastest moves that an override may ask for.
    const double faster = live ? kMostOverride / 100.0 / job_.options.feed_factor() : 1;
    outputs_.emplace(job_.options.rules, job_.options.feed_factor(), job_.options.outputs,
                     job_.options.sample_period_s, job_.program.file, job_.options.from_mm == 0);
    job_.plan.made_for(profile_writer(job_));
    plan_.emplace([this](ref::Move& move) { return take(move); },
                  ref::StreamFrame{job_.program.file, job_.program.aux_axes, faster * fastest_},
                  job_.machine, options);
}

/// Lets another thread read the program, where it may wait for it: a file.
void JobStream::read_ahead(const std::shared_ptr<ref::Workers>& workers) {
    const Options& options = job_.options;
    if (options.open_program || options.file == ref::kStandardInput) return;
    ahead_.emplace([this](ref::Move& move) { return read(*moves_, move); },
                   [this]() -> const ref::Events& { return moves_->program().events(); }, workers,
                   kAhead);
}

/// Returns the events before the end of the last move that was taken, or more.
const ref::Events& JobStream::events() const {
    return ahead_ ? ahead_->events() : moves_->program().events();
}

/// Draws the program as written: the core is too slow for splines, which the program may lack.
void JobStream::draw_as_programmed() {
    job_.options.exact_path = true;
    if (!job_.options.splines_set) job_.options.core.splines = 0;
    look_at_program();
    moves_.emplace(job_.options, job_.machine, form_);
    warn_of_exact_path(job_);
}

void JobStream::end() {
    ahead_.reset();  // nobody reads any more
    job_.events = moves_->program().events();
    const std::vector<std::string>& read = moves_->program().warnings();
    std::vector<std::string>& warnings = job_.program.warnings;
    warnings.insert(warnings.begin(), read.begin(), read.end());
    job_.dialect = moves_->program().dialect();
    if (moves_->refused()) warn_of_exact_path(job_);
    warn_of_plan(job_, bounded_, duration_s_);
    if (plan_->forced_stops() > 0) {
        job_.program.warnings.push_back(fmt::format(
            "{}:{}: warning: {} stops that nobody asked for, the first behind this move: the plan "
            "in parts could not go on there",
            job_.program.file, plan_->forced_stop_line(), plan_->forced_stops()));
    }
    job_.off = moves_->off();
    job_.smoothed = moves_->smoothed();
    if (moves_->replaced().splines > 0) job_.as_arcs = AsArcs{moves_->replaced(), {}};
}

Job JobStream::all(const LookAtPart& look) {
    keeps_ = true;
    ref::LimitWatch limits(job_.machine);
    while (const ref::Plan* part = next()) {
        if (look) look(job_, *part);
        watch(*part, limits);
        job_.plan.append(*part);
    }
    job_.limits = limits.report();
    warn_of_segments(job_);
    return std::move(job_);
}

/// Watches the limits of a part; its moves are all that the check needs.
void JobStream::watch(const ref::Plan& part, ref::LimitWatch& limits) const {
    const std::size_t first = part.segments.front().move;
    ref::Program moves;
    for (std::size_t i = first; i <= part.segments.back().move; ++i) {
        moves.moves.push_back(job_.plan.moves[i]);
    }
    ref::Plan counted = part;
    for (ref::Segment& segment : counted.segments) segment.move -= first;
    limits.add(moves, counted);
}

}  // namespace curvecore::sysc
