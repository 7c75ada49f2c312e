// SPDX-License-Identifier: Apache-2.0
#include "sysc/words/bus_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "hls/path_outputs.hpp"
#include "hls/quantise.hpp"

namespace curvecore::sysc {
namespace {

/// Length units from a change to the next one, at most: rtl/output/path_outputs.sv counts 2^27.
constexpr std::uint32_t kFarBehind = 1 << 25;

}  // namespace

RunSegment JoinedSegments::next(const ref::Segment& segment) {
    RunSegment words = hls::to_words(segment, format_);
    if (count_++ > 0) join(segment, words);
    last_ = words;
    last_turned_ = segment.aux_turned;
    return words;
}

/// Joins the words of a segment to those before. A move shorter than half a quantum of path has no
/// segment: ends and starts of a plan may differ by as much, and may round to words that differ by
/// one.
void JoinedSegments::join(const ref::Segment& segment, RunSegment& words) const {
    for (int axis = 0; axis < format_.kAxes; ++axis) {
        const auto aux = static_cast<std::size_t>(axis - 3);
        if (axis >= 3 && segment.aux_turned[aux] != last_turned_[aux]) {
            words.other_turn = true;
            continue;
        }
        if (std::abs(words.start[axis] - last_.end[axis]) > 1) {
            throw std::logic_error(
                fmt::format("segment {} does not start where the one before ended", count_ - 1));
        }
        words.start[axis] = last_.end[axis];
    }
}

std::vector<std::uint64_t> SegmentWriter::write(const ref::Segment& segment) {
    const RunTimeFormat& format = segments_.format();
    std::vector<std::uint64_t> bus(
        static_cast<std::size_t>(ref::segment_bus_words(format.kAxes - 3) + format.kFurtherWords));
    const auto number = static_cast<unsigned>(segments_.count());
    hls::pack(segments_.next(segment), number, bus.data(), format);
    check_.seal(bus.data(), bus.size());
    return bus;
}

void OutputWriter::write(ref::OutputKind kind, std::uint32_t value, std::uint32_t distance,
                         std::vector<std::uint64_t>& words) {
    words.push_back(hls::pack({kind, value, distance}, number_++));
}

void OutputWriter::write(const ref::PlannedOutput& output, std::vector<std::uint64_t>& words) {
    pass(output.place, words);
    const std::uint64_t place = output.place >> hls::kRateFrac;
    const std::uint32_t value = value_of(output);
    if (output.kind == ref::OutputKind::kBits) bits_ = value;
    write(output.kind, value, static_cast<std::uint32_t>(place - place_), words);
    place_ = place;
}

void OutputWriter::pass(std::uint64_t path, std::vector<std::uint64_t>& words) {
    while ((path >> hls::kRateFrac) > place_ + kFarBehind) {
        write(ref::OutputKind::kBits, bits_, kFarBehind, words);
        place_ += kFarBehind;
    }
}

std::uint32_t OutputWriter::value_of(const ref::PlannedOutput& output) const {
    if (output.kind == ref::OutputKind::kLevel) {
        return static_cast<std::uint32_t>(std::lround(output.value * hls::kMostLevel));
    }
    if (output.kind == ref::OutputKind::kFollow) {
        if (output.value == ref::kAtAnyButRest) return 1;
        return output.value == ref::kAtAnySpeed ? 0 : hls::follow_at(output.value * way_);
    }
    return static_cast<std::uint32_t>(output.value);
}

std::vector<std::uint64_t> ProfileWriter::write(const ref::Plan& plan, std::size_t index) {
    std::vector<std::uint64_t> words;
    path_ += plan.pieces[index].ds;
    write_outputs(plan, words);
    if (outputs_) outputs_->pass(path_, words);
    const std::size_t first = words.size();
    const auto is_before = [](const ref::PlannedBranch& branch, std::size_t piece) {
        return branch.piece < piece;
    };
    const auto branch =
        std::lower_bound(plan.branches.begin(), plan.branches.end(), index, is_before);
    if (branch != plan.branches.end() && branch->piece == index) {
        std::vector<std::uint64_t> steps;
        for (const ref::StopStep& step : branch->steps) {
            steps.push_back(hls::pack(hls::to_words(step, &step == &branch->steps.back())));
        }
        const bool again = steps == steps_;
        words.push_back(hls::pack_stop(static_cast<std::int32_t>(branch->wait), again));
        if (!again) words.insert(words.end(), steps.begin(), steps.end());
        steps_ = std::move(steps);
    }
    words.resize(words.size() + hls::kProfileBusWords);
    hls::pack(hls::to_words(plan.pieces[index]), static_cast<unsigned>(count_++),
              &words[words.size() - hls::kProfileBusWords]);
    check_.seal(&words[first], words.size() - first);
    if (index + 1 == plan.pieces.size()) output_ = 0;
    if (plan.pieces[index].final) steps_.clear();
    return words;
}

std::vector<std::uint64_t> ProfileWriter::wait(const ref::Plan& plan) {
    std::vector<std::uint64_t> words;
    write_outputs(plan, words);
    ++waits_;
    return words;
}

void ProfileWriter::write_outputs(const ref::Plan& plan, std::vector<std::uint64_t>& words) {
    if (!outputs_) return;
    for (; output_ < plan.outputs.size(); ++output_) {
        const ref::PlannedOutput& output = plan.outputs[output_];
        if (output.place > path_ || output.waits > waits_) break;
        outputs_->write(output, words);
    }
}

}  // namespace curvecore::sysc
