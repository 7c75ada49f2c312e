// SPDX-License-Identifier: Apache-2.0
#include "ref/path/smooth_stream.hpp"

#include <algorithm>
#include <utility>

#include "ref/curve/angle_between.hpp"
#include "ref/limits/limits.hpp"
#include "ref/moves/move_part.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr std::size_t kLargest = 8;  // times a window that has no place for a cut
constexpr std::size_t kPieces = 16;  // mean number of pieces of a window's moves

bool smoothable(const Move& move) {
    const bool moves = move.kind == Move::Kind::kArc || move.start != move.end;  // X Y Z
    return move.tolerance > 0 && move.kind != Move::Kind::kCubic &&
           move.kind != Move::Kind::kTable && moves && move.aux_start == move.aux_end;
}

bool together(const Move& a, const Move& b) {
    return smoothable(b) && a.rapid == b.rapid && a.tolerance == b.tolerance && !a.exact_stop &&
           !(a.dwell > 0);
}

bool stops(const Move& before, const Move& after) {
    const Vec3 out = place_on(before, before.length()).tangent;
    return before.exact_stop || before.dwell > 0 ||
           angle_between(out, place_on(after, 0).tangent) > kSmallTurn;
}

}  // namespace

SmoothStream::SmoothStream(MoveSource source, const Machine& machine, double share,
                           MovesCheck carried, std::size_t window)
    : source_(std::move(source)),
      pace_(machine),
      share_(share),
      carried_(std::move(carried)),
      window_(window) {}

bool SmoothStream::next(Move& move) {
    if (!begun_reading_) read_ahead();
    begun_reading_ = true;
    while (drawn_.empty() && (ahead_ || !group_.empty())) draw();
    if (drawn_.empty()) {
        if (error_) std::rethrow_exception(error_);
        return false;
    }
    move = drawn_.front();
    drawn_.pop_front();
    return true;
}

void SmoothStream::read_ahead() {
    Move move;
    try {
        ahead_ = source_(move) ? std::optional(move) : std::nullopt;
    } catch (const InputError&) {
        ahead_.reset();
        error_ = std::current_exception();
    }
    if (ahead_) ++report_.moves;
}

/// Reads until a group has `count` moves, or kPieces pieces for each of these, or ends.
void SmoothStream::read_group(std::size_t count) {
    const auto parts = [this](const Move& move) {
        return PathJoints::parts(move, share_ * move.tolerance);
    };
    std::size_t pieces = 0;
    for (const Move& move : group_) pieces += parts(move);
    while (more_ && group_.size() < count && pieces < kPieces * count) {
        more_ = ahead_ && (group_.empty() || together(group_.back(), *ahead_));
        if (!more_) return;
        pieces += parts(*ahead_);
        group_.push_back(*ahead_);
        read_ahead();
    }
}

void SmoothStream::draw() {
    if (group_.empty() && !smoothable(*ahead_)) {
        before_ = ahead_;
        read_ahead();
        give({*before_});
        return;
    }
    for (std::size_t size = window_;; size *= 2) {
        read_group(size);
        if (!draw_group(size >= kLargest * window_)) continue;
        return;
    }
}

/// Draws all of it, or up to a cut; returns false if there is no place for one, unless it `must`.
bool SmoothStream::draw_group(bool must) {
    const Rest rest{!before_ || stops(*before_, group_.front()),
                    !more_ && (!ahead_ || stops(group_.back(), *ahead_))};
    const PathJoints joints(group_, share_ * group_.front().tolerance, rest, first_, pace_);
    Smoothed report = report_;
    Drawing drawing(joints, pace_, begun_, report);
    const std::optional<PathCut> cut = more_ ? drawing.best_cut() : std::nullopt;
    if (more_ && !cut && !must) return false;
    std::deque<Move> moves = drawing.run(cut);
    if (!carried_ || carried_(moves)) {
        report_ = report;
    } else {
        refused_ = true;
        moves = Drawing(joints, pace_, begun_, report).run_as_programmed(cut);
    }
    give(std::move(moves));
    if (!cut) {
        before_ = group_.back();
        group_.clear();
        first_.reset();
        begun_.reset();
        more_ = true;
        return true;
    }
    first_ = joints[cut->joint];
    begun_ = PathCut{0, cut->s - first_->s, cut->curve};
    group_.clear();
    for (std::size_t i = cut->joint; i < joints.count(); ++i) group_.push_back(joints.move(i));
    return true;
}

void SmoothStream::give(std::deque<Move> moves) {
    for (const Move& move : moves) look_at(move, report_);
    drawn_ = std::move(moves);
}

}  // namespace curvecore::ref
