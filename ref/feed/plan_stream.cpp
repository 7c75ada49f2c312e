// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/plan_stream.hpp"

#include <algorithm>
#include <utility>

#include "ref/feed/core_slowed.hpp"
#include "ref/feed/feed_profile.hpp"
#include "ref/feed/stops/hold_bounds.hpp"
#include "ref/format/path_words.hpp"
#include "ref/numeric/unlimited.hpp"
#include "ref/numeric/workers.hpp"
#include "ref/segment/spline_cut.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr std::size_t kLargest = 8;    // times the size of a window that has no place for a cut
constexpr std::size_t kFewMoves = 32;  // moves that a window may have, whatever their length
constexpr double kLongMove = 1;        // mm; above this mean length a window has fewer moves
constexpr std::size_t kMostPlanned = 16000;  // moves, or segments: a window has no more
constexpr std::size_t kFewest = 3;           // moves that it may have, whatever their time
constexpr double kAmple = 1.2;  // horizons of motion that are read, by the pace of the last window
constexpr double kShort = 0.7;  // share of the horizon below which a window reads more

double length_of(const std::vector<Move>& moves) {
    double length = 0;
    for (const Move& move : moves) length += move.length();
    return length;
}

/// Windows share moves.
PlanOptions with_cuts(PlanOptions options) {
    if (!options.cuts) options.cuts = std::make_shared<KnownCuts>();
    return options;
}

}  // namespace

/// A window's moves with their motion, from the given part to a rest.
struct PlanStream::Window {
    Geometry geometry;
    std::optional<WindowProfile> profile;
    std::size_t open = 0;   // planned moves that are given
    std::size_t first = 0;  // move of the program, from its start
    std::size_t end = 0;

    /// Returns the number of planned moves in the first `moves` of its program, and in any case a
    /// few more than are given.
    std::size_t least(std::size_t moves) const {
        const std::size_t given = open < geometry.moves.size() ? geometry.moves[open].move : 0;
        const std::size_t most = std::max(moves, given + kFewest);
        std::size_t i = open;
        while (i < geometry.moves.size() && geometry.moves[i].move < most) ++i;
        return i;
    }
};

PlanStream::PlanStream(MoveSource source, StreamFrame frame, Machine machine,
                       const PlanOptions& options)
    : source_(std::move(source)),
      machine_(std::move(machine)),
      options_(with_cuts(options)),
      fastest_(frame.fastest),
      size_(options.window),
      horizon_(horizon(machine_, options_)) {
    program_.file = std::move(frame.file);
    program_.aux_axes = frame_.aux_axes = frame.aux_axes;
    frame_.unit_mm = options_.unit_mm;
    frame_.tick_s = options_.tick_s();
    set_hold_bounds(machine_, options_, frame.fastest, frame_);
}

PlanStream::~PlanStream() = default;

std::optional<Plan> PlanStream::next() {
    if (behind_) std::rethrow_exception(std::exchange(behind_, nullptr));
    std::optional<PlannedPart> given = held_ ? std::exchange(held_, std::nullopt) : next_part();
    if (!given) return {};
    if (!options_.workers || horizon_ != kUnlimited) {
        given->find_branches(machine_, options_);
        return std::move(given->plan);
    }
    each(options_.workers, 2, [&](std::size_t branches) {
        if (branches == 1) return given->find_branches(machine_, options_);
        try {
            held_ = next_part();
        } catch (...) {
            behind_ = std::current_exception();
        }
    });
    return std::move(given->plan);
}

std::optional<PlannedPart> PlanStream::next_part() {
    bool all = false;      // everything is planned, whatever its size
    std::size_t seen = 0;  // moves of the window before
    for (std::size_t size = size_; !ended_;) {
        read(size);
        std::unique_ptr<Window> window = look(all ? SIZE_MAX : kMostPlanned);
        const std::size_t count = window->geometry.moves.size();
        if (count == 0) break;
        FeedTask task = task_of(*window);
        task.whole = !std::exchange(begun_, true) && !more_;
        task.more = more_;
        task.least = all ? count : window->least(planned_before());
        if (!profile(*window, task)) return stop_where_planned();
        const std::size_t enough = window->profile->enough;
        if (enough < count) {
            put_back(window->geometry.moves[enough].move);
            size = size_;
            all = true;
        } else if (task.whole) {
            return give_out_whole(*window);
        } else if (!all && program_.moves.size() > seen && is_short(*window)) {
            seen = program_.moves.size();
        } else if (more_ && window->profile->cut == 0 && size < kLargest * size_) {
            size *= 2;
            all = true;
        } else {
            if (!all) size_ = std::min(options_.window, size_ + size_ / 2);
            return give_out(std::move(window));
        }
    }
    ended_ = true;
    const bool nothing = !std::exchange(begun_, true);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    if (nothing) throw InputError(program_.file, 0, "the program moves nothing");
    return {};
}

void PlanStream::fail() {
    error_ = std::current_exception();
    more_ = false;
}

/// Returns the time of the window's open moves at their feeds, s.
double PlanStream::open_time() const {
    double time = 0;
    for (std::size_t i = begun_moves_; i < program_.moves.size(); ++i) {
        time += least_time(program_.moves[i], machine_.velocity);
    }
    return time;
}

/// Learns how slow motion is here. Returns true if the window has less of it than it should.
bool PlanStream::is_short(const Window& window) {
    if (horizon_ == kUnlimited) return false;
    const std::vector<double>& times = window.profile->motion.times();
    const double time = times.back() - times[window.open];
    pace_ = std::max(1.0, time / open_time());
    return more_ && time < kShort * horizon_ && program_.moves.size() < size_;
}

void PlanStream::read(std::size_t size) {
    double length = length_of(program_.moves) + length_of(next_);
    double time = horizon_ == kUnlimited ? 0 : open_time();
    const auto is_full = [&] {
        const std::size_t moves = program_.moves.size() + next_.size();
        return moves > size ||
               (moves > kFewMoves && length > kLongMove * static_cast<double>(size)) ||
               (moves >= begun_moves_ + kFewest && pace_ * time > kAmple * horizon_);
    };
    try {
        while (more_ && !is_full()) {
            take_next();
            read_next();
            length += length_of(next_);
            for (const Move& move : next_) time += least_time(move, machine_.velocity);
        }
    } catch (const InputError&) {
        fail();
    }
    check_next();
}

/// @throws InputError of the source
void PlanStream::read_next() {
    const double quantum = options_.unit_mm * kQuantum;
    more_ = false;
    for (Move move; !more_ && take(move);) {
        next_.push_back(move);
        more_ = move.length() >= quantum;
    }
    if (!more_) take_next();
}

void PlanStream::take_next() {
    program_.moves.insert(program_.moves.end(), next_.begin(), next_.end());
    next_.clear();
}

bool PlanStream::take(Move& move) {
    if (!back_.empty()) {
        move = back_.front();
        back_.pop_front();
        return true;
    }
    if (error_ || !source_(move)) return false;
    raise(move, raised_);
    return true;
}

/// Returns the number of moves of program_ that the last window has: the next may have to follow it
/// there.
std::size_t PlanStream::planned_before() const { return before_ ? before_->end - dropped_ : 0; }

/// Puts back the window's moves from `first` on.
void PlanStream::put_back(std::size_t first) {
    const auto from = program_.moves.begin() + static_cast<std::ptrdiff_t>(first);
    back_.insert(back_.begin(), next_.begin(), next_.end());
    back_.insert(back_.begin(), from, program_.moves.end());
    program_.moves.erase(from, program_.moves.end());
    size_ = first;
    next_.clear();
    read_next();
}

void PlanStream::raise_feed(double factor) {
    const double more = std::max(1.0, factor / raised_);
    raised_ *= more;
    for (std::size_t i = begun_moves_; i < program_.moves.size(); ++i) {
        raise(program_.moves[i], more);
    }
    for (Move& move : next_) raise(move, more);
    for (Move& move : back_) raise(move, more);
}

void PlanStream::raise(Move& move, double factor) const {
    if (!move.rapid) move.feed = std::min(factor * move.feed, std::max(move.feed, fastest_));
}

/// Checks that a move that ends at rest because more follows is not the last.
void PlanStream::check_next() {
    if (more_) check(next_.back());
}

/// Returns false, and the program ends before the move, if the machine or the core cannot make it.
bool PlanStream::check(const Move& move) {
    Program one;
    one.file = program_.file;
    one.aux_axes = program_.aux_axes;
    one.moves.push_back(move);
    try {
        make_geometry(one, machine_, options_);
    } catch (const InputError&) {
        fail();
        return false;
    }
    return true;
}

/// Plans a window of as many moves as `most` planned ones, but at least of all that were planned
/// before.
std::unique_ptr<PlanStream::Window> PlanStream::look(std::size_t most) {
    auto window = std::make_unique<Window>();
    const auto make = [&](std::size_t planned) {
        window->geometry = make_geometry(program_, machine_, options_, miss_, planned);
        const std::vector<PlannedMove>& moves = window->geometry.moves;
        const std::size_t count = std::max(moves.size(), window->geometry.segments.size());
        return count < planned ? program_.moves.size() : moves.back().move + 1;
    };
    std::size_t moves = 0;
    try {
        moves = make(most);
    } catch (const InputError&) {
        leave_out_what_fails();
        moves = make(most);
    }
    if (moves < planned_before()) moves = make(SIZE_MAX);
    if (moves < program_.moves.size()) put_back(moves);
    window->open = given_moves(given_);
    window->first = dropped_;
    window->end = dropped_ + program_.moves.size();
    return window;
}

/// Drops the first move that fails and every later move.
void PlanStream::leave_out_what_fails() {
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
        if (check(program_.moves[i])) continue;
        program_.moves.resize(i);
        return;
    }
}

FeedTask PlanStream::task_of(Window& window) const {
    return {program_, machine_, options_, window.geometry, frame_, given_};
}

/// Profiles the window. Returns false if it cannot continue the given motion.
bool PlanStream::profile(Window& window, const FeedTask& task) {
    try {
        window.profile = profile_window(task);
    } catch (const InputError&) {
        if (!before_) {
            ended_ = true;
            throw;
        }
        fail();
        program_.moves.resize(planned_before());
    }
    return window.profile.has_value();
}

/// Gives out a window that is the whole program.
PlannedPart PlanStream::give_out_whole(Window& window) {
    PlannedPart whole;
    Plan& plan = whole.plan;
    plan = std::move(window.profile->plan);
    plan.core_slowed =
        core_slowed(task_of(window), window.profile->motion, 0, window.geometry.moves.size());
    plan.segments = std::move(window.geometry.segments);
    set_segment_feeds(program_, options_, plan.pieces, plan.segments);
    plan.segments.back().last = plan.pieces.back().final = ended_ = true;
    return whole;
}

/// Gives out the window up to its cut, or to its rest.
PlannedPart PlanStream::give_out(std::unique_ptr<Window> window) {
    const std::vector<PlannedMove>& moves = window->geometry.moves;
    const std::size_t cut = window->profile->cut;
    PlannedPart given = part(*window, window->open, cut > 0 ? cut : moves.size());
    if (cut == 0) {
        drop(program_.moves.size());
        return given;
    }
    const std::size_t first = given_from(window->profile->motion, cut, machine_);
    drop(moves[first].move);
    begun_moves_ = moves[cut - 1].move - moves[first].move + 1;
    miss_ = moves[first].miss;
    given_ = window->profile->motion.given(first, cut);
    before_ = std::move(window);
    return given;
}

PlannedPart PlanStream::stop_where_planned() {
    const std::unique_ptr<Window> window = std::move(before_);
    if (forced_stops_++ == 0) forced_stop_line_ = program_.moves[window->end - dropped_ - 1].line;
    PlannedPart rest = part(*window, window->profile->cut, window->geometry.moves.size());
    drop(window->end - dropped_);
    return rest;
}

/// Drops the moves before `first`: the next window begins there, at rest unless a motion is given.
void PlanStream::drop(std::size_t first) {
    program_.moves.erase(program_.moves.begin(),
                         program_.moves.begin() + static_cast<std::ptrdiff_t>(first));
    dropped_ += first;
    begun_moves_ = 0;
    miss_ = 0;
    given_.clear();
    before_.reset();
}

/// Returns the plan of the planned moves from `first` up to `end` (not included).
PlannedPart PlanStream::part(Window& window, std::size_t first, std::size_t end) {
    const std::vector<PlannedMove>& moves = window.geometry.moves;
    const auto length = [&](std::size_t from, std::size_t to) {
        std::uint64_t sum = 0;
        for (std::size_t i = from; i < to; ++i) sum += moves[i].length;
        return sum;
    };
    const std::uint64_t from = length(0, first);
    const std::uint64_t to = from + length(first, end);
    PlannedPart part;
    Plan& plan = part.plan = frame_;
    plan.slowed_moves = window.profile->plan.slowed_moves;
    plan.slowed_line = window.profile->plan.slowed_line;
    plan.core_slowed =
        core_slowed(task_of(window), window.profile->motion, first, end, dropped_ - window.first);
    for (const Segment& segment : window.geometry.segments) {
        if (segment.s_start < from || segment.s_start >= to) continue;
        plan.segments.push_back(segment);
        plan.segments.back().s_start -= from;
    }
    window.profile->motion.append(first, end, plan.pieces);
    if (end == moves.size()) window.profile->motion.append_last_dwell(plan.pieces);
    plan.duration_s = ticks_of(plan.pieces) * plan.tick_s;
    set_segment_feeds(program_, options_, plan.pieces, plan.segments);
    ended_ = end == moves.size() && window.end == dropped_ + program_.moves.size() && !more_;
    if (options_.has_branches()) {
        part.moves.emplace(moves, first, end, program_, dropped_ - window.first);
    }
    for (Segment& segment : plan.segments) {
        segment.s_start += path_;
        segment.move += window.first;
    }
    path_ += to - from;
    plan.segments.back().last = plan.pieces.back().final = ended_;
    return part;
}

}  // namespace curvecore::ref
