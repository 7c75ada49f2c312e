// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/virtual_board.hpp"

#include <utility>

#include "Vmotion_board.h"
#include "sysc/board/clocked_dut.hpp"

namespace curvecore::sysc {

struct VirtualBoard::Model {
    ClockedDut<Vmotion_board> dut;
};

VirtualBoard::VirtualBoard(std::function<void(const VirtualStep&)> step,
                           std::vector<VirtualSwitch> switches, bool limits)
    : model_(std::make_unique<Model>()),
      step_(std::move(step)),
      switches_(std::move(switches)),
      limits_(limits) {
    ClockedDut<Vmotion_board>& dut = model_->dut;
    dut.limit_cycles(UINT64_MAX);
    dut->byte_valid_i = 0;
    dut->byte_ready_i = 1;
    dut->estop_i = 0;
    dut->probe_i = 0;
    set_switches();
    dut.reset();
}

VirtualBoard::~VirtualBoard() = default;

void VirtualBoard::offer(const Bytes& frame) {
    const Bytes line = slip_encode(frame);
    offered_.insert(offered_.end(), line.begin(), line.end());
}

bool VirtualBoard::taken() const { return offered_.empty(); }

std::uint64_t VirtualBoard::clocks() const { return model_->dut.cycle(); }

void VirtualBoard::set_switches() {
    unsigned closed = 0;
    for (const VirtualSwitch& one : switches_) {
        const std::int64_t place = places_[one.axis];
        if (one.from <= place && place <= one.to) closed |= 1U << one.axis;
    }
    model_->dut->home_i = closed;
    model_->dut->limit_i = limits_ ? closed : 0;
}

std::optional<Bytes> VirtualBoard::clock() {
    ClockedDut<Vmotion_board>& dut = model_->dut;
    // Inputs of the coming edge; ready does not depend on them.
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
            places_[axis] += back ? -1 : 1;
            step_({dut.cycle(), axis, back});
        }
    }
    if (rises != 0) set_switches();
    return answer;
}

}  // namespace curvecore::sysc
