// SPDX-License-Identifier: Apache-2.0
#include "ref/outputs/placed_outputs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/format/path_words.hpp"
#include "ref/text/input_error.hpp"

namespace curvecore::ref {
namespace {

constexpr double kRoom = 0.75;     // of the board's queue; the rest for those that count long ways
constexpr double kLate_s = 10e-3;  // of a host
constexpr double kPeak = 4;        // speed within a piece over its mean, at most

}  // namespace

void PlacedOutputs::add(const Move& move, const Events& events) {
    Move asked = move;
    asked.feed /= raised_;
    const std::vector<OutputCourse::Change> changes = course_.next(asked, events);
    add(changes, changes.empty() ? 0 : move.length());
    ++moves_;
}

void PlacedOutputs::end(const Events& events) { add(course_.end(events), 0); }

void PlacedOutputs::add(const std::vector<OutputCourse::Change>& changes, double length) {
    for (const OutputCourse::Change& change : changes) {
        changes_.push_back({moves_,
                            change.share * length,
                            change.behind.dwell,
                            {0, change.kind, change.value, change.line, change.behind.waits}});
    }
}

void PlacedOutputs::place(Plan& part) {
    const auto put = [&](std::uint64_t begin) {
        const Change& change = changes_.front();
        PlannedOutput output = change.output;
        output.place = begin + std::llround(change.length / part.unit_mm * kQuantaPerUnit);
        if (change.dwelt) output.place += static_cast<std::uint64_t>(kQuantaPerUnit);
        if (!placed_.empty()) output.place = std::max(output.place, placed_.back().place);
        placed_.push_back(output);
        changes_.pop_front();
    };
    for (const Segment& segment : part.segments) {
        while (!changes_.empty() && changes_.front().move <= segment.move) put(segment.s_start);
    }
    const Segment& last = part.segments.back();
    path_ = last.s_start + last.length;
    while (last.last && !changes_.empty()) put(path_);
    while (!placed_.empty() && (placed_.front().place < path_ || last.last)) {
        part.outputs.push_back(placed_.front());
        part.outputs.back().place = std::min(placed_.front().place, path_);
        placed_.pop_front();
    }
    if (waiting_words_ == 0) return;
    check_ways(part);
    check_room(part);
}

void PlacedOutputs::check_ways(const Plan& part) const {
    const double least = kLeastWay * part.unit_mm / sample_s_;  // mm/s
    for (const PlannedOutput& output : part.outputs) {
        const bool follows = output.kind == OutputKind::kFollow && output.value > 0;
        if (!follows || output.value > least) continue;
        throw InputError(
            file_, output.line,
            fmt::format("the laser's power is to follow a feed of {:.4g} mm/min, and the board "
                        "counts ways from {:.4g} mm/min on: a smaller --unit, or M3",
                        60 * output.value, 60 * least));
    }
    const double greatest = kGreatestWay / kPeak * part.unit_mm / sample_s_;
    for (const ProfilePiece& piece : part.pieces) {
        const double speed = piece.ds / kQuantaPerUnit * part.unit_mm / (piece.ticks * part.tick_s);
        if (piece.ticks == 0 || speed < greatest) continue;
        throw InputError(file_, 0,
                         fmt::format("a speed of {:.4g} mm/min, and outputs of the board "
                                     "count ways up to {:.4g} mm/min: a greater --unit",
                                     60 * speed, 60 * greatest));
    }
}

void PlacedOutputs::check_room(const Plan& part) {
    const double needed = 2.0 * part.stop_ticks + kLate_s / part.tick_s;
    const auto most = static_cast<std::size_t>(kRoom * waiting_words_);
    std::uint64_t path = path_;
    for (const ProfilePiece& piece : part.pieces) path -= piece.ds;
    std::size_t next = 0;
    for (const ProfilePiece& piece : part.pieces) {
        for (; next < part.outputs.size() && part.outputs[next].place <= path + piece.ds; ++next) {
            const double gone =
                piece.ds == 0 ? 0 : double(part.outputs[next].place - path) / piece.ds;
            times_.push_back(ticks_ + gone * piece.ticks);
            if (times_.size() <= most) continue;
            if (times_.back() - times_.front() < needed) {
                throw InputError(
                    file_, part.outputs[next].line,
                    fmt::format("{} changes of outputs within {:.3f} s: the board keeps {}, which "
                                "have to last for two stops, {:.3f} s: a lower feed, or fewer",
                                most, (times_.back() - times_.front()) * part.tick_s,
                                waiting_words_, needed * part.tick_s));
            }
            times_.pop_front();
        }
        path += piece.ds;
        ticks_ += piece.ticks;
    }
}

}  // namespace curvecore::ref
