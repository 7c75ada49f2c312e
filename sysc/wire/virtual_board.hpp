// SPDX-License-Identifier: Apache-2.0
// The Verilated motion_board: bytes and clocks in, bytes and steps out.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sysc/wire/slip.hpp"

namespace curvecore::sysc {

struct VirtualStep {
    std::uint64_t clock = 0;
    int axis = 0;
    bool back = false;
};

/// A home switch: closed where the axis' count of steps is in [from, to].
struct VirtualSwitch {
    int axis = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
};

class VirtualBoard {
  public:
    static constexpr int kAxes = 3;
    static constexpr int kPeriodLog2 = 8;
    static constexpr double kClockHertz = 2'560'000;

    /// `step` is called for every rising edge of a step pin while the drives are on.
    VirtualBoard(std::function<void(const VirtualStep&)> step, std::vector<VirtualSwitch> switches,
                 bool limits);
    ~VirtualBoard();

    /// A frame that the board shall take.
    void offer(const Bytes& frame);
    /// All that was offered has gone in.
    bool taken() const;
    /// One clock; an answer that it completed.
    std::optional<Bytes> clock();
    std::uint64_t clocks() const;

  private:
    struct Model;

    void set_switches();

    std::unique_ptr<Model> model_;
    std::function<void(const VirtualStep&)> step_;
    std::vector<VirtualSwitch> switches_;
    bool limits_;                               // they are limit switches too
    std::array<std::int64_t, kAxes> places_{};  // steps
    std::deque<std::uint8_t> offered_;
    SlipDecoder answers_;
    unsigned steps_ = 0;  // levels of the pins
};

}  // namespace curvecore::sysc
