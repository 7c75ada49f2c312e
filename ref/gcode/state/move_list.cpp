// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/state/move_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ref/gcode/state/coordinates.hpp"
#include "ref/outputs/output_course.hpp"
#include "ref/outputs/placed_waits.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSlowestFeed = 1e-3 / 60;  // mm/s
constexpr double kFastestFeed = 1e9 / 60;
constexpr std::size_t kNamedLines = 3;  // lines named for each code that is left out

/// Returns "S in lines 3, 4, 5 and 20 more".
std::string with_lines(const std::string& code, const std::vector<int>& lines, int count) {
    const auto named = static_cast<int>(lines.size());
    std::string text = fmt::format("{} in line{} {}", code, count > 1 ? "s" : "", lines.front());
    for (int i = 1; i < named; ++i) {
        text += fmt::format("{}{}", i + 1 == count ? " and " : ", ", lines[i]);
    }
    return count > named ? text + fmt::format(" and {} more", count - named) : text;
}

}  // namespace

double feed_of(double per_minute, const Place& place) {
    const double feed = per_minute / 60;
    if (!(feed >= kSlowestFeed && feed <= kFastestFeed)) {
        place.refuse(fmt::format("the feed is out of range: {:g} mm/min", per_minute));
    }
    return feed;
}

bool MoveList::moves(const Move& move, const Place& place) {
    if (move.length() > 0) return true;
    warn("a move of length 0 is left out", place);
    return false;
}

void MoveList::append(const Move& move) {
    if (value_changed_) note_values(program_.moves.empty() || program_.moves.back().exact_stop);
    for (int i = 0; i < kAuxAxes; ++i) {
        if (move.aux_end[i] != move.aux_start[i]) {
            program_.aux_axes = std::max(program_.aux_axes, i + 1);
        }
    }
    if (program_.moves.empty() && first_.dwell > 0) {
        first_.start = first_.end = move.start;
        first_.aux_start = first_.aux_end = move.aux_start;
        first_.rapid = move.rapid;
        first_.feed = move.feed;
        first_.exact_stop = true;
        program_.moves.push_back(std::exchange(first_, {}));
    }
    program_.moves.push_back(move);
    program_.moves.back().from = length_;
    length_ += move.length();
    program_.moves.back().to = length_;
}

std::vector<Move> MoveList::pieces_of(const std::vector<Cubic>& cubics, const Move& whole,
                                      const Place& place) {
    Move piece = whole;
    piece.kind = Move::Kind::kCubic;
    piece.exact_stop = false;
    std::vector<Move> pieces;
    for (const Cubic& cubic : cubics) {
        piece.cubic = cubic;
        if (!(piece.length() > kStill)) {
            warn("a piece of a spline without length is left out", place);
            continue;
        }
        piece.end = cubic.position(1);
        pieces.push_back(piece);
        piece.start = piece.end;
    }
    if (pieces.empty()) place.refuse("the curve collapses to a point");
    pieces.back().end = whole.end;
    pieces.back().exact_stop = whole.exact_stop;
    return pieces;
}

void MoveList::stop() {
    if (!program_.moves.empty()) program_.moves.back().exact_stop = true;
}

void MoveList::dwell(double seconds, const Place& place) {
    if (program_.moves.empty()) {
        first_.dwell += seconds;
        if (first_.line == 0) first_.line = place.line;
        return;
    }
    stop();
    program_.moves.back().dwell += seconds;
}

void MoveList::warn(const std::string& text, const Place& place) {
    ++warnings_.try_emplace(text, Warning{place.program_line, 0}).first->second.count;
}

void MoveList::leave_out(const std::string& code, const Place& place, double value,
                         bool along_path) {
    const double rest = program_.moves.empty() ? first_.dwell : program_.moves.back().dwell;
    const bool waits = obeys_.waits && waits_for_person(code);
    events_.add(code, {place.line, 0, value, length_, rest, waits});
    if (waits || (obeys_.waits && code == "T")) return;
    if (obeys_.outputs && switches_outputs(code, obeys_.analog)) return;
    LeftOut& all = left_out_[code];
    all.changed = all.changed || (along_path && value != all.value);
    value_changed_ = value_changed_ || all.changed;
    all.value = value;
    ++all.count;
    if (all.lines.size() < kNamedLines) all.lines.push_back(place.program_line);
}

/// Notes before the next move which values have changed: they hold from here on.
void MoveList::note_values(bool stopped) {
    value_changed_ = false;
    for (auto& [code, left_out] : left_out_) {
        left_out.changes = left_out.changes || (left_out.changed && !stopped);
        left_out.changed = false;
    }
}

/// Warns of codes in the order of their first lines; the warning names the first of them.
void MoveList::warn_of_left_out() {
    std::vector<std::pair<std::string, LeftOut>> all(left_out_.begin(), left_out_.end());
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.second.lines.front() < b.second.lines.front();
    });
    std::string codes;
    std::string changing;
    for (const auto& [code, left_out] : all) {
        codes += (codes.empty() ? "" : "; ") + with_lines(code, left_out.lines, left_out.count);
        if (left_out.changes) changing += (changing.empty() ? "" : " or ") + code;
    }
    if (codes.empty()) return;
    if (!changing.empty()) changing = fmt::format("; moves of different {} become one", changing);
    const bool analog = obeys_.outputs && (left_out_.count("M67") + left_out_.count("M68")) > 0;
    warn(fmt::format("only axes move, nothing is switched or waited for: {}{}{}", codes, changing,
                     analog ? "; with --full-q PWM is Q of M67 and M68" : ""),
         {program_.file, all.front().second.lines.front()});
}

std::vector<Move> MoveList::take(bool last) {
    std::vector<Move> taken;
    if (program_.moves.empty()) return taken;
    const auto end = program_.moves.end() - (last ? 0 : 1);
    taken.assign(program_.moves.begin(), end);
    program_.moves.erase(program_.moves.begin(), end);
    return taken;
}

Program MoveList::finish() {
    warn_of_left_out();
    for (const auto& [text, warning] : warnings_) {
        const std::string line = warning.line > 0 ? fmt::format(":{}", warning.line) : "";
        program_.warnings.push_back(
            fmt::format("{}{}: warning: {}{}", program_.file, line, text,
                        warning.count > 1 ? fmt::format(" ({} times)", warning.count) : ""));
    }
    if (program_.moves.empty()) {
        throw InputError(program_.file, 0, "the program has no moves");
    }
    stop();
    return std::move(program_);
}

}  // namespace curvecore::ref
