// SPDX-License-Identifier: Apache-2.0
#include "sysc/virtual/virtual_board.hpp"

#include <algorithm>
#include <utility>

#include "Vmotion_board.h"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::sysc {

struct VirtualBoard::Model {
    ClockedDut<Vmotion_board> dut;
};

VirtualBoard::VirtualBoard(std::function<void(const VirtualStep&)> step, VirtualAxes axes)
    : model_(std::make_unique<Model>()), step_(std::move(step)), axes_(std::move(axes)) {
    ClockedDut<Vmotion_board>& dut = model_->dut;
    dut.limit_cycles(UINT64_MAX);
    dut->byte_valid_i = 0;
    dut->byte_ready_i = 1;
    dut->estop_i = 0;
    dut->probe_i = 0;
    set_switches();
    set_encoders();
    dut.reset();
}

VirtualBoard::~VirtualBoard() = default;

void VirtualBoard::offer(const Bytes& frame) {
    const Bytes line = slip_encode(frame);
    offered_.insert(offered_.end(), line.begin(), line.end());
}

bool VirtualBoard::taken() const { return offered_.empty(); }

std::uint64_t VirtualBoard::clocks() const { return model_->dut.cycle(); }

bool VirtualBoard::drives_on() const { return model_->dut->enable_o != 0; }

void VirtualBoard::set_switches() {
    unsigned closed = 0;
    for (const VirtualRange& one : axes_.switches) {
        const std::int64_t place = places_[one.axis];
        if (one.from <= place && place <= one.to) closed |= 1U << one.axis;
    }
    model_->dut->home_i = closed;
    model_->dut->limit_i = axes_.limits ? closed : 0;
}

void VirtualBoard::move(int axis, bool back) {
    given_[axis] += back ? -1 : 1;
    const auto slips = [&](const VirtualRange& one) {
        return one.axis == axis && one.from <= given_[axis] && given_[axis] <= one.to;
    };
    if (std::any_of(axes_.slips.begin(), axes_.slips.end(), slips)) return;
    places_[axis] += back ? -1 : 1;
    const auto lag = static_cast<std::uint64_t>(axes_.lag_s * kClockHertz);
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
    model_->dut->encoder_a_i = a;
    model_->dut->encoder_b_i = b;
}

std::optional<Bytes> VirtualBoard::clock() {
    ClockedDut<Vmotion_board>& dut = model_->dut;
    // Inputs for the coming edge; ready does not depend on them.
    const bool goes = dut->byte_ready_o != 0 && !offered_.empty();
    dut->byte_valid_i = goes ? 1 : 0;
    if (goes) {
        dut->byte_i = offered_.front();
        offered_.pop_front();
    }
    std::optional<Bytes> answer;
    if (dut->byte_valid_o != 0) answer = answers_.take(dut->byte_o);
    dut.tick();
    const unsigned rises = dut->enable_o != 0 ? dut->step_o & ~steps_ : 0;
    steps_ = dut->step_o;
    for (int axis = 0; rises >> axis != 0; ++axis) {
        if ((rises >> axis & 1) != 0) {
            const bool back = (dut->direction_o >> axis & 1) != 0;
            move(axis, back);
            step_({dut.cycle(), axis, back});
        }
    }
    if (rises != 0) set_switches();
    if (!late_.empty()) set_encoders();
    return answer;
}

}  // namespace curvecore::sysc
