// SPDX-License-Identifier: Apache-2.0
#include "sysc/virtual/virtual_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hls/place_scaler.hpp"
#include "ref/curves/curve_table.hpp"
#include "sysc/cache/core_cache.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {

namespace {

/// Times in which the build makes its samples, and a simulation keeps up with real time.
VirtualTimes times_of(Build build) {
    if (build == Build::kEngine) return {13, 5'120'000};
    if (build == Build::kParallel) return {8, 2'560'000};
    throw UsageError("--build: a virtual board is engine or parallel");
}

std::unique_ptr<VirtualModel> model_of(Build build, std::shared_ptr<const ref::CurveTable> table,
                                       const VirtualTimes& times) {
    if (table && build != Build::kEngine) {
        throw UsageError("--curve: a table is drawn by --build engine");
    }
    CachedModel model{"board", "motion_board", "sysc/virtual/compiled_board.cpp", {}, {}, 4096,
                      1024};
    model.core.build = build;
    model.core.splines = 1;
    model.core.mode = 1;
    ref::add_table(std::move(table), model.core);
    model.rate_bits = hls::kStepFraction + times.period_log2;
    for (const auto& [name, value] : {std::pair("Splines", 1),
                                      {"Mode", 1},
                                      {"PeriodLog2", times.period_log2},
                                      {"ClockHertz", static_cast<int>(times.clock_hz)},
                                      {"Encoders", 2},
                                      {"Outputs", 1024},
                                      {"Shaper", 256}}) {
        model.parameters.push_back(fmt::format("{}={}", name, value));
    }
    auto* const make = reinterpret_cast<MakeVirtualModel*>(CoreCache().open(model, false));
    return std::unique_ptr<VirtualModel>(make());
}

}  // namespace

VirtualBoard::VirtualBoard(std::function<void(const VirtualStep&)> step, VirtualAxes axes,
                           Build build, std::shared_ptr<const ref::CurveTable> table)
    : times_(times_of(build)),
      model_(model_of(build, std::move(table), times_)),
      step_(std::move(step)),
      axes_(std::move(axes)) {
    set_switches();
    set_encoders();
    model_->reset();
}

void VirtualBoard::offer(const Bytes& frame) {
    const Bytes line = slip_encode(frame);
    offered_.insert(offered_.end(), line.begin(), line.end());
}

bool VirtualBoard::taken() const { return offered_.empty(); }

void VirtualBoard::set_switches() {
    unsigned closed = 0;
    for (const VirtualRange& one : axes_.switches) {
        const std::int64_t place = places_[one.axis];
        if (one.from <= place && place <= one.to) closed |= 1U << one.axis;
    }
    model_->in.home = closed;
    model_->in.limit = axes_.limits ? closed : 0;
}

void VirtualBoard::move(int axis, bool back) {
    given_[axis] += back ? -1 : 1;
    const auto slips = [&](const VirtualRange& one) {
        return one.axis == axis && one.from <= given_[axis] && given_[axis] <= one.to;
    };
    if (std::any_of(axes_.slips.begin(), axes_.slips.end(), slips)) return;
    places_[axis] += back ? -1 : 1;
    const auto lag = static_cast<std::uint64_t>(axes_.lag_s * times_.clock_hz);
    late_.push_back({clocks() + lag, axis, places_[axis]});
}

void VirtualBoard::set_encoders() {
    for (; !late_.empty() && late_.front().clock <= clocks(); late_.pop_front()) {
        edges_[late_.front().axis] = late_.front().place;
    }
    unsigned a = 0;
    unsigned b = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto phase = static_cast<unsigned>(edges_[axis] & 3);
        a |= (phase == 1 || phase == 2 ? 1U : 0U) << axis;
        b |= (phase >> 1) << axis;
    }
    model_->in.encoder_a = a;
    model_->in.encoder_b = b;
}

std::optional<Bytes> VirtualBoard::clock() {
    // Inputs for the coming edge; ready does not depend on them.
    const bool goes = model_->out.byte_ready && !offered_.empty();
    model_->in.byte_valid = goes;
    if (goes) {
        model_->in.byte = offered_.front();
        offered_.pop_front();
    }
    std::optional<Bytes> answer;
    if (model_->out.byte_valid) answer = answers_.take(model_->out.byte);
    model_->tick();
    const VirtualModel::Outputs& out = model_->out;
    const unsigned rises = out.enable ? out.step & ~steps_ : 0;
    steps_ = out.step;
    for (int axis = 0; rises >> axis != 0; ++axis) {
        if ((rises >> axis & 1) != 0) {
            const bool back = (out.direction >> axis & 1) != 0;
            move(axis, back);
            step_({clocks(), axis, back});
        }
    }
    const unsigned edges = out.outputs ^ outputs_;
    outputs_ = out.outputs;
    for (int output = 0; axes_.edge && edges >> output != 0; ++output) {
        if ((edges >> output & 1) == 0) continue;
        axes_.edge({clocks(), output, (outputs_ >> output & 1) != 0});
    }
    if (rises != 0) set_switches();
    if (!late_.empty()) set_encoders();
    return answer;
}

}  // namespace curvecore::sysc
