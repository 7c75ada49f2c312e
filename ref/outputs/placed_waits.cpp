// SPDX-License-Identifier: Apache-2.0
#include "ref/outputs/placed_waits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace curvecore::ref {
namespace {

constexpr double kSameEnd = 1e-6;  // mm

}  // namespace

bool waits_for_person(const std::string& code) {
    return code == "M0" || code == "M6" || code == "M60";
}

int first_wait(const Events& events, double length) {
    const auto found = std::find_if(events.list().begin(), events.list().end(),
                                    [](const Events::Event& event) { return event.waits; });
    const bool is_one = found != events.list().end() && found->length < length - kSamePlace;
    return is_one ? found->line : 0;
}

void PlacedWaits::add(const Move& move, const Events& events) {
    const auto take = [&](double length, std::optional<std::size_t> behind, bool wanted = true) {
        for (; taken_ < events.list().size() && events.list()[taken_].length < length; ++taken_) {
            const Events::Event& event = events.list()[taken_];
            const std::string& code = events.code_of(event);
            if (code == "T") tool_ = event.value;
            if (!event.waits || !wanted) continue;
            const std::string what = code == "M6" ? fmt::format("M6 T{:g}", tool_) : code;
            waits_.push_back({behind, move.end, event.rest, {0, 0, 0, event.line, what}});
        }
    };
    if (moves_ == 0) {
        take(move.from - kLeftOut, {}, false);
        take(move.from + kSamePlace, {});
    }
    take(move.to + kSamePlace, moves_);
    ++moves_;
}

void PlacedWaits::place(Plan& part) {
    piece_ = segments_ = 0;
    path_ = part.segments.front().s_start;
    if (ended_ || (!waits_.empty() && !waits_.front().behind)) put(part);
    if (rest_ticks_ > 0) rest(part);
    for (std::size_t i = 0; i < part.segments.size(); ++i) {
        Segment& segment = part.segments[i];
        segment.ticks = static_cast<std::uint32_t>(segment.ticks - owed_ticks_);
        owed_ticks_ = 0;
        segment_ticks_ += segment.ticks;
        if (!ends(part, i)) continue;
        segments_ = i + 1;
        end(part, segment);
    }
    for (; piece_ < part.pieces.size(); ++piece_) piece_ticks_ += part.pieces[piece_].ticks;
}

/// Returns true if the program waits behind this segment.
bool PlacedWaits::ends(const Plan& part, std::size_t index) {
    const Segment& segment = part.segments[index];
    if (segment.last) waits_.clear();
    if (waits_.empty() || segment.move < *waits_.front().behind) return false;
    if (segment.move > *waits_.front().behind) {
        throw std::logic_error("a wait behind a move that has no segment");
    }
    if (index + 1 < part.segments.size()) return part.segments[index + 1].move != segment.move;
    return (segment.end * part.unit_mm - waits_.front().end).norm() < kSameEnd;
}

/// Ends a program with this segment, and with the dwell behind it that comes before the wait.
void PlacedWaits::end(Plan& part, Segment& segment) {
    const std::uint64_t place = segment.s_start + segment.length;
    for (; path_ < place; ++piece_) {
        path_ += part.pieces[piece_].ds;
        piece_ticks_ += part.pieces[piece_].ticks;
    }
    if (path_ != place) throw std::logic_error("a wait where the axes do not rest");
    for (const Wait& wait : waits_) {
        if (wait.behind != waits_.front().behind) break;
        rest_ticks_ = rest_ticks(wait.rest, part.tick_s);
    }
    owed_ticks_ = static_cast<std::int64_t>(piece_ticks_ + rest_ticks_ - segment_ticks_);
    segment.ticks = static_cast<std::uint32_t>(segment.ticks + owed_ticks_);
    segment.last = true;
    segment_ticks_ = piece_ticks_ = 0;
    rest(part);
}

/// Passes the dwell before a wait, which may go on in the next part.
void PlacedWaits::rest(Plan& part) {
    for (; rest_ticks_ > 0 && piece_ < part.pieces.size(); ++piece_) {
        ProfilePiece& piece = part.pieces[piece_];
        if (piece.ds > 0) throw std::logic_error("a dwell before a wait is shorter than planned");
        if (piece.ticks > rest_ticks_) split(part);
        rest_ticks_ -= part.pieces[piece_].ticks;
    }
    if (rest_ticks_ > 0) return;
    part.pieces[piece_ - 1].final = true;
    ended_ = true;
    if (piece_ < part.pieces.size()) put(part);
}

/// Makes two rests of the present one: the first is the rest of the dwell.
void PlacedWaits::split(Plan& part) const {
    const auto first = part.pieces.begin() + static_cast<std::ptrdiff_t>(piece_);
    const auto second = part.pieces.insert(first, *first) + 1;
    (second - 1)->ticks = static_cast<std::uint32_t>(rest_ticks_);
    second->ticks -= static_cast<std::uint32_t>(rest_ticks_);
    for (PlannedBranch& branch : part.branches) branch.piece += branch.piece > piece_ ? 1 : 0;
}

/// Puts the waits of a place before the next piece: outputs before them may be of its part.
void PlacedWaits::put(Plan& part) {
    const std::optional<std::size_t> behind = waits_.front().behind;
    for (; !waits_.empty() && waits_.front().behind == behind; waits_.pop_front()) {
        part.waits.push_back(waits_.front().wait);
        part.waits.back().place = path_;
        part.waits.back().segments = segments_;
        part.waits.back().pieces = piece_;
    }
    ended_ = false;
}

}  // namespace curvecore::ref
